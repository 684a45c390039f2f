#include "pbrt/ply_header.h"

#include <charconv>
#include <optional>

#include "base/error.h"

namespace drc::pbrt {
namespace {

struct PlyTypeName {
    std::string_view name;
    PlyType type;
};
constexpr PlyTypeName kPlyTypes[] = {
    {"char", PlyType::Int8},       {"int8", PlyType::Int8},       {"uchar", PlyType::UInt8},
    {"uint8", PlyType::UInt8},     {"short", PlyType::Int16},     {"int16", PlyType::Int16},
    {"ushort", PlyType::UInt16},   {"uint16", PlyType::UInt16},   {"int", PlyType::Int32},
    {"int32", PlyType::Int32},     {"uint", PlyType::UInt32},     {"uint32", PlyType::UInt32},
    {"float", PlyType::Float32},   {"float32", PlyType::Float32}, {"double", PlyType::Float64},
    {"float64", PlyType::Float64},
};

class HeaderParser {
  public:
    HeaderParser(std::string_view file, const std::string& path) : file_(file), path_(path) {}

    PlyHeader parse() {
        if (file_.starts_with("\xEF\xBB\xBF")) at_ = 3;  // byte order mark
        // Old Macintosh programs end lines with only a carriage return. Only the first line is examined, because after
        // the header a line feed may be the first byte of the data.
        const size_t firstEnd = file_.find_first_of("\r\n", at_);
        if (firstEnd != std::string_view::npos && firstEnd + 1 < file_.size() && file_[firstEnd] == '\r' &&
            file_[firstEnd + 1] != '\n')
            lineEnd_ = '\r';
        if (nextLine() != std::vector<std::string_view>{"ply"}) fail("is not a PLY file: it does not begin with 'ply'");
        bool hasFormat = false;
        for (;;) {
            const auto words = nextLine();
            if (words.empty() || words[0] == "comment" || words[0] == "obj_info") continue;
            if (words[0] == "end_header") break;
            if (words[0] == "format" && words.size() == 3) {
                format(words[1]);
                hasFormat = true;
            } else if (words[0] == "element" && words.size() == 3) {
                element(words);
            } else if (words[0] == "property" && !header_.elements.empty()) {
                property(words);
            } else {
                fail("has a malformed header line that begins with '" + std::string(words[0]) + "'");
            }
        }
        if (!hasFormat) fail("has no 'format' line in its header");
        header_.dataOffset = at_;
        checkSize();
        return std::move(header_);
    }

  private:
    [[noreturn]] void fail(const std::string& what) const { throw Error({path_, line_, 1}, "the PLY file " + what); }

    std::vector<std::string_view> nextLine() {
        const size_t end = file_.find(lineEnd_, at_);
        if (end == std::string_view::npos) fail("ends within its header");
        std::string_view line = file_.substr(at_, end - at_);
        at_ = end + 1;
        ++line_;
        std::vector<std::string_view> words;
        for (;;) {
            const size_t start = line.find_first_not_of(" \t\r");
            if (start == std::string_view::npos) return words;
            const size_t stop = std::min(line.find_first_of(" \t\r", start), line.size());
            words.push_back(line.substr(start, stop - start));
            line.remove_prefix(stop);
        }
    }

    void format(std::string_view name) {
        if (name == "ascii")
            header_.format = PlyFormat::Ascii;
        else if (name == "binary_little_endian")
            header_.format = PlyFormat::LittleEndian;
        else if (name == "binary_big_endian")
            header_.format = PlyFormat::BigEndian;
        else
            fail("has the unknown format '" + std::string(name) + "'");
    }

    void element(const std::vector<std::string_view>& words) {
        PlyElement element;
        element.name = words[1];
        const char* const end = words[2].data() + words[2].size();
        const auto [stop, error] = std::from_chars(words[2].data(), end, element.count);
        if (error != std::errc() || stop != end) fail("has the malformed count '" + std::string(words[2]) + "'");
        header_.elements.push_back(std::move(element));
    }

    PlyType type(std::string_view name) const {
        for (const PlyTypeName& entry : kPlyTypes)
            if (entry.name == name) return entry.type;
        fail("has a property of the unknown type '" + std::string(name) + "'");
    }

    void property(const std::vector<std::string_view>& words) {
        PlyProperty property;
        property.isList = words.size() == 5 && words[1] == "list";
        if (!property.isList && words.size() != 3) fail("has a malformed property line");
        if (property.isList) property.countType = type(words[2]);
        if (property.isList && property.countType >= PlyType::Float32) fail("counts the items of a list by fractions");
        property.type = type(words[words.size() - 2]);
        property.name = words.back();
        header_.elements.back().properties.push_back(std::move(property));
    }

    // Rejects element counts that the file cannot contain, before memory is allocated for the elements.
    void checkSize() {
        uint64_t left = file_.size() - at_;
        for (const PlyElement& element : header_.elements) {
            const uint64_t size = element.minimumSize(header_.format);
            if (size == 0 && element.count > 0) fail("has an element '" + element.name + "' without properties");
            // No blank needs to follow the last ASCII value.
            const uint64_t slack = header_.format == PlyFormat::Ascii ? 1 : 0;
            if (element.count > 0 && element.count > (left + slack) / size)
                fail("is cut short: it promises " + std::to_string(element.count) + " of '" + element.name +
                     "', more than its " + std::to_string(file_.size()) + " bytes can hold");
            left -= std::min(left, element.count * size);
        }
    }

    std::string_view file_;
    const std::string& path_;
    size_t at_ = 0;
    char lineEnd_ = '\n';
    int line_ = 0;
    PlyHeader header_;
};

}  // namespace

size_t sizeOf(PlyType type) {
    switch (type) {
        case PlyType::Int8:
        case PlyType::UInt8:
            return 1;
        case PlyType::Int16:
        case PlyType::UInt16:
            return 2;
        case PlyType::Float64:
            return 8;
        default:
            return 4;
    }
}

uint64_t PlyElement::minimumSize(PlyFormat format) const {
    uint64_t size = 0;
    for (const PlyProperty& property : properties)
        size += format == PlyFormat::Ascii ? 2 : sizeOf(property.isList ? property.countType : property.type);
    return size;
}

PlyHeader parsePlyHeader(std::string_view file, const std::string& path) { return HeaderParser(file, path).parse(); }

}  // namespace drc::pbrt
