// What the fuzzers feed with bytes of their own making: each reads the text or file as the program would and may throw
// drc::Error, but nothing else, and must not crash, hang or ask for memory out of all proportion.
#pragma once
#include <string>
#include <string_view>

namespace drc::fuzz {

void tokenizer(std::string_view bytes);
void parser(std::string_view bytes);  // a pbrt scene, confined; it reads no other files
void ply(std::string_view bytes);
void safetensors(std::string_view bytes);
void examples(std::string_view bytes);  // a shard of them
void tga(std::string_view bytes);
void hdr(std::string_view bytes);      // a Radiance picture
void picture(std::string_view bytes);  // of any format that its first bytes name, but for the two above

// The scene without slashes: what it names is looked for in a folder that does not exist, and nowhere else. Else a
// fuzzer that hits upon "/dev/..." or a file of the machine would open it.
std::string confined(std::string_view scene);

}  // namespace drc::fuzz
