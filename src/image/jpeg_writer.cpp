#include "image/jpeg_writer.h"

#include <fmt/core.h>

#include <csetjmp>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "base/error.h"
#include "image/color.h"

// libjpeg's headers need <cstdio> before them.
#include <jpeglib.h>

// On an error libjpeg calls error_exit, which must not return: here it calls longjmp. Therefore, after setjmp, each
// function below calls nothing but libjpeg and has no objects with destructors.

namespace drc {
namespace {

class JpegWriter {
  public:
    explicit JpegWriter(const std::string& path) : path_(path) {
        jpeg_.err = jpeg_std_error(&errors_);
        errors_.error_exit = &JpegWriter::jump;
        errors_.output_message = [](j_common_ptr) {};
        jpeg_.client_data = this;
    }
    ~JpegWriter() {
        jpeg_destroy_compress(&jpeg_);
        std::free(bytes_);
    }
    JpegWriter(const JpegWriter&) = delete;
    JpegWriter& operator=(const JpegWriter&) = delete;

    void start(int width, int height, int quality) {
        if (!startOrJump(JDIMENSION(width), JDIMENSION(height), quality)) fail();
    }
    void writeRow(JSAMPROW row) {
        if (!writeRowOrJump(row)) fail();
    }
    std::string finish() {
        if (!finishOrJump()) fail();
        return {reinterpret_cast<const char*>(bytes_), size_};
    }

  private:
    bool startOrJump(JDIMENSION width, JDIMENSION height, int quality) {
        constexpr int kFullColours = 90;
        if (setjmp(jump_)) return false;
        jpeg_create_compress(&jpeg_);
        jpeg_mem_dest(&jpeg_, &bytes_, &size_);
        jpeg_.image_width = width;
        jpeg_.image_height = height;
        jpeg_.input_components = 3;
        jpeg_.in_color_space = JCS_RGB;
        jpeg_set_defaults(&jpeg_);
        jpeg_set_quality(&jpeg_, quality, TRUE);
        jpeg_.optimize_coding = TRUE;
        if (quality >= kFullColours) jpeg_.comp_info[0].h_samp_factor = jpeg_.comp_info[0].v_samp_factor = 1;
        jpeg_start_compress(&jpeg_, TRUE);
        return true;
    }
    bool writeRowOrJump(JSAMPROW row) {
        if (setjmp(jump_)) return false;
        jpeg_write_scanlines(&jpeg_, &row, 1);
        return true;
    }
    bool finishOrJump() {
        if (setjmp(jump_)) return false;
        jpeg_finish_compress(&jpeg_);
        return true;
    }
    [[noreturn]] static void jump(j_common_ptr jpeg) {
        JpegWriter& writer = *static_cast<JpegWriter*>(jpeg->client_data);
        jpeg->err->format_message(jpeg, writer.message_);
        std::longjmp(writer.jump_, 1);
    }
    [[noreturn]] void fail() const { throw Error(fmt::format("cannot write {}: {}", path_, message_)); }

    const std::string& path_;
    jpeg_compress_struct jpeg_ = {};
    jpeg_error_mgr errors_ = {};
    std::jmp_buf jump_ = {};
    unsigned char* bytes_ = nullptr;  // libjpeg allocates them
    unsigned long size_ = 0;
    char message_[JMSG_LENGTH_MAX] = {};
};

}  // namespace

std::string encodeJpeg(const Image& linear, int quality, const std::string& path) {
    if (linear.empty()) throw Error(fmt::format("cannot write {}: the image is empty", path));
    if (linear.width() > JPEG_MAX_DIMENSION || linear.height() > JPEG_MAX_DIMENSION)
        throw Error(fmt::format("cannot write {}: the image is {}, and a JPEG has at most {} pixels a side", path,
                                sizeString(linear), JPEG_MAX_DIMENSION));
    JpegWriter writer(path);
    writer.start(linear.width(), linear.height(), quality);
    std::vector<uint8_t> row(size_t(linear.width()) * 3);
    for (int y = 0; y < linear.height(); ++y) {
        for (int x = 0; x < linear.width(); ++x) {
            const Rgb c = linear.rgb(x, y);
            for (int i = 0; i < 3; ++i) row[size_t(x) * 3 + size_t(i)] = toByte(srgbEncode(c[i]));
        }
        writer.writeRow(row.data());
    }
    return writer.finish();
}

}  // namespace drc
