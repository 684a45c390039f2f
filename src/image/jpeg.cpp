#include "image/jpeg.h"

#include <fmt/core.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <vector>

// libjpeg's headers need <cstdio> before them, and jerror.h the settings that jpeglib.h includes.
// clang-format off
#include <jpeglib.h>
#include <jerror.h>
// clang-format on

// On an error libjpeg calls error_exit, which must not return: here it calls longjmp. Therefore, after setjmp, each
// function below calls nothing but libjpeg and has no objects with destructors.

namespace drc {
namespace {

class JpegReader {
  public:
    explicit JpegReader(const EncodedImage& encoded) : encoded_(encoded) {
        jpeg_.err = jpeg_std_error(&errors_);
        errors_.error_exit = &JpegReader::jump;
        errors_.emit_message = &JpegReader::noteWarning;
        errors_.output_message = [](j_common_ptr) {};
        progress_.progress_monitor = &JpegReader::checkScans;
        jpeg_.client_data = this;
    }
    ~JpegReader() { jpeg_destroy_decompress(&jpeg_); }
    JpegReader(const JpegReader&) = delete;
    JpegReader& operator=(const JpegReader&) = delete;

    void readHeader() {
        if (!readHeaderOrJump()) fail();
    }
    void start() {
        if (!startOrJump()) fail();
    }
    void readRow(JSAMPROW row) {
        if (!readRowOrJump(row)) fail();
    }
    void finish() {
        if (!finishOrJump()) fail();
    }

    const jpeg_decompress_struct& info() const { return jpeg_; }
    bool isInks() const { return jpeg_.jpeg_color_space == JCS_CMYK || jpeg_.jpeg_color_space == JCS_YCCK; }

  private:
    bool readHeaderOrJump() {
        if (setjmp(jump_)) return false;
        jpeg_create_decompress(&jpeg_);
        jpeg_.progress = &progress_;
        jpeg_mem_src(&jpeg_, reinterpret_cast<const unsigned char*>(encoded_.bytes.data()), encoded_.bytes.size());
        jpeg_read_header(&jpeg_, TRUE);
        return true;
    }
    bool startOrJump() {
        if (setjmp(jump_)) return false;
        if (isInks()) jpeg_.out_color_space = JCS_CMYK;
        jpeg_start_decompress(&jpeg_);
        return true;
    }
    bool readRowOrJump(JSAMPROW row) {
        if (setjmp(jump_)) return false;
        jpeg_read_scanlines(&jpeg_, &row, 1);
        return true;
    }
    bool finishOrJump() {
        if (setjmp(jump_)) return false;
        jpeg_finish_decompress(&jpeg_);
        return true;
    }

    static JpegReader& of(j_common_ptr jpeg) { return *static_cast<JpegReader*>(jpeg->client_data); }

    [[noreturn]] static void jump(j_common_ptr jpeg) {
        JpegReader& reader = of(jpeg);
        if (reader.isCutShort_)
            std::strcpy(reader.message_, "it is cut short");
        else
            jpeg->err->format_message(jpeg, reader.message_);
        std::longjmp(reader.jump_, 1);
    }
    // libjpeg only warns of damage and fills in missing data; here damage is an error. A missing end marker alone is
    // not: some cameras leave it out. It is an error in progressive files, where each scan refines the one before it,
    // and in arithmetic-coded files, where codes may be left out at the end: there only the marker shows that nothing
    // else is missing.
    static void noteWarning(j_common_ptr jpeg, int level) {
        if (level >= 0) return;  // no warning
        const auto& info = reinterpret_cast<jpeg_decompress_struct&>(*jpeg);
        switch (jpeg->err->msg_code) {
            case JWRN_JPEG_EOF:
                of(jpeg).isCutShort_ = true;
                if (info.progressive_mode || info.arith_code) jump(jpeg);
                return;
            case JWRN_HIT_MARKER:
            case JWRN_HUFF_BAD_CODE:
            case JWRN_ARITH_BAD_CODE:
            case JWRN_MUST_RESYNC:
                jump(jpeg);
            default:
                return;
        }
    }
    // Limits the number of scans, because libjpeg processes the whole picture for each scan, even one of a few bytes.
    static void checkScans(j_common_ptr jpeg) {
        const auto& info = reinterpret_cast<jpeg_decompress_struct&>(*jpeg);
        if (info.input_scan_number <= limits::kJpegScans) return;
        JpegReader& reader = of(jpeg);
        std::snprintf(reader.message_, sizeof(reader.message_), "it has more than %d scans", limits::kJpegScans);
        std::longjmp(reader.jump_, 1);
    }
    [[noreturn]] void fail() const { failDecoding(encoded_, message_); }

    const EncodedImage& encoded_;
    jpeg_decompress_struct jpeg_ = {};
    jpeg_error_mgr errors_ = {};
    jpeg_progress_mgr progress_ = {};
    std::jmp_buf jump_ = {};
    bool isCutShort_ = false;  // libjpeg has read past the end of the data
    char message_[JMSG_LENGTH_MAX] = {};
};

// Size of the 16-bit coefficients, which libjpeg keeps for the whole picture if it is stored in several scans.
double coefficientBytes(const jpeg_decompress_struct& info) {
    double bytes = 0;
    for (int i = 0; i < info.num_components; ++i)
        bytes +=
            double(info.comp_info[i].width_in_blocks) * info.comp_info[i].height_in_blocks * DCTSIZE2 * sizeof(JCOEF);
    return bytes;
}

}  // namespace

ImageFile decodeJpeg(const EncodedImage& encoded) {
    JpegReader reader(encoded);
    reader.readHeader();
    const jpeg_decompress_struct& info = reader.info();
    const bool isGrey = info.num_components == 1;
    if (!isGrey && info.num_components != 3 && !reader.isInks())
        failDecoding(encoded, fmt::format("it has {} components, and 1 (grey), 3 (colours) or 4 (inks) are read",
                                          info.num_components));
    const MemoryClaim memory =
        claimMemory(encoded, info.image_width, info.image_height, isGrey ? 1 : 3, coefficientBytes(info));
    reader.start();

    const int width = int(info.output_width), height = int(info.output_height);
    ImageFile file{isGrey ? Image(width, height, {"Y"}) : Image(width, height), Encoding::UInt8};
    std::vector<uint8_t> row(size_t(width) * size_t(info.output_components));
    for (int y = 0; y < height; ++y) {
        reader.readRow(row.data());
        float* out = file.image.pixel(0, y);
        if (reader.isInks()) {
            for (size_t x = 0; x < size_t(width); ++x)
                for (size_t c = 0; c < 3; ++c) {
                    const float through = fromByte(row[4 * x + c]) * fromByte(row[4 * x + 3]);
                    out[3 * x + c] = fromByte(uint8_t(through * 255 + .5f));
                }
        } else {
            for (size_t i = 0; i < row.size(); ++i) out[i] = fromByte(row[i]);
        }
    }
    reader.finish();
    return file;
}

}  // namespace drc
