// Writes JSON piece by piece, because documents with the vertices of all meshes are too large for a tree in memory.
#pragma once
#include <fmt/core.h>

#include <functional>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>

namespace drc::pbrt {

// Every value inside of an object must follow a key().
//
//     JsonStream json(write);
//     json.object([&] { json.member("width", 3); });
class JsonStream {
  public:
    // write: called with consecutive parts of the text.
    explicit JsonStream(std::function<void(std::string_view)> write) : write_(std::move(write)) {}

    void value(double number) { put("{}", number); }
    void value(float number) { put("{}", number); }
    void value(size_t number) { put("{}", number); }
    void value(int number) { put("{}", number); }
    void value(bool truth) { put("{}", truth); }
    void value(std::nullptr_t) { put("null"); }
    // Bytes that are not UTF-8 become U+FFFD.
    void value(const std::string& text) {
        put("{}", nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace));
    }
    void value(const char* text) { value(std::string(text)); }

    void key(std::string_view name) {
        put("\"{}\": ", name);
        isFirst_ = true;
    }
    template <typename T>
    void member(std::string_view name, const T& v) {
        key(name);
        value(v);
    }
    template <typename F>
    void object(const F& members) {
        nest('{', '}', members);
    }
    template <typename F>
    void array(const F& values) {
        nest('[', ']', values);
    }
    // Begins a new line before the next value.
    void newLine() { startsLine_ = true; }
    // Ends the text with a new line, and writes what has not been written.
    void finish() {
        text_ += '\n';
        flush();
    }

  private:
    void flush() {
        write_(text_);
        text_.clear();
    }
    template <typename... Values>
    void put(fmt::format_string<Values...> format, Values&&... values) {
        separate();
        fmt::format_to(std::back_inserter(text_), format, std::forward<Values>(values)...);
        if (text_.size() >= kPiece) flush();
    }
    template <typename F>
    void nest(char open, char close, const F& contents) {
        separate();
        text_ += open;
        isFirst_ = true;
        contents();
        text_ += close;
        isFirst_ = false;
    }
    void separate() {
        if (!isFirst_) text_ += startsLine_ ? "," : ", ";
        if (startsLine_) text_ += '\n';
        isFirst_ = startsLine_ = false;
    }

    static constexpr size_t kPiece = size_t(1) << 16;
    std::function<void(std::string_view)> write_;
    std::string text_;
    bool isFirst_ = true, startsLine_ = false;
};

}  // namespace drc::pbrt
