// How much a file may ask for. A number in a file must not decide alone how much memory is taken or how long the
// program runs: a scene may come from anywhere. Each limit lies far beyond what real scenes have, and each says why it
// is where it is. What grows in proportion to the file itself needs none here; what a few bytes can blow up does.
// Memory that is within these limits and yet more than the machine has: see memory.h.
#pragma once
#include <cstddef>
#include <cstdint>

namespace drc::limits {

// --- Files ---------------------------------------------------------------------------------------------------------

// Of a scene or a mesh: the largest published scenes have single files of some gigabytes. More is a sparse file, whose
// reading would take minutes before the first error.
inline constexpr uint64_t kFileBytes = uint64_t(32) << 30;
// Of a picture: the most pixels (below) with four floats each take 16 GiB, uncompressed.
inline constexpr uint64_t kPictureBytes = uint64_t(16) << 30;
// Of a measured spectrum or a lens: a sample a tenth of a nanometre takes 100 KB, the longest zoom lens 2 KB.
inline constexpr uint64_t kTableBytes = uint64_t(256) << 10;
// Of a safetensors header: a line of 100 bytes a tensor, and we have less than a hundred. The parsed header takes up to
// fifty times as much memory.
inline constexpr uint64_t kSafetensorsHeaderBytes = uint64_t(1) << 20;
// Of the header of a shard of examples: ten settings and the scene's name.
inline constexpr uint64_t kShardHeaderBytes = uint64_t(64) << 10;
// Texels along a side of an example's maps, and its realisations: together they bound what one record unpacks to, 60
// MB.
inline constexpr int kExampleMapSize = 256;
inline constexpr int kExampleInputs = 64;
// What a gzip'd file may grow to: the larger of the two. Meshes and scenes shrink to a tenth, rarely to a fiftieth.
inline constexpr size_t kGunzipBytes = size_t(64) << 20;
inline constexpr size_t kGunzipRatio = 250;  // to the compressed size

// Warnings that are shown and kept; nobody reads more.
inline constexpr size_t kWarnings = 1000;
// Of a message that quotes a file.
inline constexpr size_t kMessageBytes = 4000;

// --- Scenes --------------------------------------------------------------------------------------------------------

// Files within files. Exporters write two or three levels.
inline constexpr size_t kIncludeDepth = 64;
// Files that each include the next one twice are read 2^n times. Together, Includes may be of so many files, and have
// so many bytes of text beyond a multiple of what is on the disk (a file may well be included for each of its copies).
inline constexpr size_t kIncludes = 100'000;
inline constexpr uint64_t kIncludedBytes = uint64_t(1) << 30;
inline constexpr uint64_t kIncludedRatio = 64;
// Blocks within blocks, each of which keeps a graphics state of about 1 KB: hand-written files have ten, exported
// hierarchies a hundred.
inline constexpr size_t kBlockDepth = 1024;
// Parameters of one directive, and of all Attribute directives of one target: every one is compared with every other,
// and pbrt's longest list has thirty.
inline constexpr size_t kParameters = 256;
// Numbers and strings that the Attribute directives of a target may give together: every later shape gets a copy.
inline constexpr size_t kAttributeValues = 1024;
// Textures of textures: how deep (each level is a call within a call), and how many lookups one lookup leads to (a
// texture that uses another one twice, and so on, has 2^n). Exported node graphs have some ten and some hundred.
inline constexpr int kTextureDepth = 100;
inline constexpr int kTextureLookups = 4096;
// Farthest lookups apart along a footprint: beyond it a longer one is blurred across, which nobody sees.
inline constexpr float kAnisotropy = 64;
// Octaves of noise: at most as many as there are with features that a float tells apart.
inline constexpr int kOctaves = 64;
// Of a coordinate. Embree leaves out what lies beyond 1.8e18, and squares of distances must be floats.
inline constexpr float kCoordinate = 1e18f;
// From the world to the space of an instanced object, by which rays are multiplied: with it, those of scenes of a
// thousand kilometres stay within the limit of a coordinate.
inline constexpr float kInstanceScale = 1e9f;
// Instances, those of parts that move within objects included: a file may ask for their product. One that moves counts
// as many times as there are moments that stand for its motion, up to 65.
inline constexpr size_t kInstanceSteps = size_t(1) << 24;
// Triangles that a scene's subdivision surfaces may become: 64 times those of a picture of a million pixels, one a
// pixel. They take some 11 GB by the time that rays are traced, and 30 GB more where they are lights.
inline constexpr double kSubdividedTriangles = 1 << 26;
// Pieces that a scene's curves may be cut into: a coat of ten million hairs with a dozen each. They take some 24 GB, as
// ribbons 32. A segment of a curve may have 64 of them, and takes six bytes of a file.
inline constexpr size_t kCurvePieces = size_t(1) << 27;
// Surfaces of a lens, all of which every ray meets: the longest zoom lenses have some fifty.
inline constexpr size_t kLensSurfaces = 256;

// --- Pictures ------------------------------------------------------------------------------------------------------

// Along one side: more than any camera or scan has.
inline constexpr int kImageSide = 1 << 16;
// In all: 32768 x 32768, the largest maps that are on offer.
inline constexpr int64_t kImagePixels = int64_t(1) << 30;
// Layers of a production's EXR file have some two hundred.
inline constexpr int kImageChannels = 1024;
// Scans of a JPEG, each of which goes through the whole picture: progressive ones have some ten.
inline constexpr int kJpegScans = 500;
// Of the film. One of all the pixels that this allows needs more memory than machines have (see MemoryClaim), a crop
// window of it does not.
inline constexpr int kFilmSide = 1 << 16;
// That a scene may ask for, a pixel: beyond it, a float's digits hide what another sample adds.
inline constexpr int kSamplesPerPixel = 1 << 24;

}  // namespace drc::limits
