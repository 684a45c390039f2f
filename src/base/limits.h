// Upper limits on what an input file may request. Scenes may come from anywhere, so a single number in a file must not
// decide how much memory is allocated or how long the program runs. Every limit is far above what real scenes contain;
// its comment gives the reason for its value. Limits are only needed where a few bytes can request a lot; data in
// proportion to the file's own size needs none. Requests within these limits that still exceed the machine's memory are
// caught by MemoryClaim (memory.h).
#pragma once
#include <cstddef>
#include <cstdint>

namespace drc::limits {

// --- Files ---------------------------------------------------------------------------------------------------------

// Size of a scene or mesh file. The largest published scenes have single files of several gigabytes. A larger one is
// probably a sparse file, which would take minutes to read before the first error.
inline constexpr uint64_t kFileBytes = uint64_t(32) << 30;
// Size of an image file: kImagePixels pixels of four floats take 16 GiB uncompressed.
inline constexpr uint64_t kPictureBytes = uint64_t(16) << 30;
// Size of a measured spectrum or a lens description. A spectrum sampled every 0.1 nm takes 100 KB, the longest zoom
// lens 2 KB.
inline constexpr uint64_t kTableBytes = uint64_t(256) << 10;
// Size of a file with a tabulated BSDF. The largest published ones are about 100 MB.
inline constexpr uint64_t kBsdfBytes = uint64_t(1) << 30;
// Size of a safetensors header. Each tensor needs about 100 bytes of it, and our networks have fewer than a hundred
// tensors. Parsing needs up to fifty times the header's size in memory.
inline constexpr uint64_t kSafetensorsHeaderBytes = uint64_t(1) << 20;
// Size of the header of a shard of training examples: ten settings and the scene's name.
inline constexpr uint64_t kShardHeaderBytes = uint64_t(64) << 10;
// Texels along a side of a training example's maps, and one-sample realisations per example. Together they limit the
// unpacked size of one record to 60 MB.
inline constexpr int kExampleMapSize = 256;
inline constexpr int kExampleInputs = 64;
// Unpacked size of a gzip file: whichever of the two limits is larger. Meshes and scenes compress to a tenth, rarely to
// a fiftieth, of their size.
inline constexpr size_t kGunzipBytes = size_t(64) << 20;
inline constexpr size_t kGunzipRatio = 250;  // relative to the compressed size

// Number of different warnings that are stored and shown. Nobody reads more.
inline constexpr size_t kWarnings = 1000;
// Length of a message that quotes a file, in bytes.
inline constexpr size_t kMessageBytes = 4000;

// --- Scenes --------------------------------------------------------------------------------------------------------

// Nesting depth of Include. Exporters nest two or three levels.
inline constexpr size_t kIncludeDepth = 64;
// A chain of n files, each of which includes the next one twice, is read 2^n times. These limit a scene's number of
// Includes, and the bytes of text that they read: kIncludedBytes plus kIncludedRatio times the size of the included
// files on disk, because a scene may legitimately include one file once per copy of an object.
inline constexpr size_t kIncludes = 100'000;
inline constexpr uint64_t kIncludedBytes = uint64_t(1) << 30;
inline constexpr uint64_t kIncludedRatio = 64;
// Nesting depth of attribute blocks; each level stores a graphics state of about 1 KB. Hand-written files nest ten
// deep, exported hierarchies a hundred.
inline constexpr size_t kBlockDepth = 1024;
// Parameters of one directive, and of all Attribute directives with the same target. The limit matters because
// duplicates are found by comparing every pair. The longest parameter list in pbrt has thirty.
inline constexpr size_t kParameters = 256;
// Numbers and strings that the Attribute directives of one target may set in total; every later shape stores a copy.
inline constexpr size_t kAttributeValues = 1024;
// Nesting depth of textures (each level is a nested call), and number of texture lookups that one lookup may cause: a
// chain of n textures, each of which uses the next one twice, causes 2^n. Exported node graphs have about ten levels
// and about a hundred lookups.
inline constexpr int kTextureDepth = 100;
inline constexpr int kTextureLookups = 4096;
// Largest ratio of the axes of an anisotropically filtered footprint. Beyond it the minor axis is widened, which is not
// visible.
inline constexpr float kAnisotropy = 64;
// Octaves of noise. Higher octaves have features that float coordinates cannot resolve.
inline constexpr int kOctaves = 64;
// Absolute value of a coordinate. Embree ignores geometry beyond 1.8e18, and squared distances must be finite floats.
inline constexpr float kCoordinate = 1e18f;
// Scale of the transform from world space to an instanced object, which is applied to rays. Within this limit, the rays
// of a scene a thousand kilometres across stay within kCoordinate.
inline constexpr float kInstanceScale = 1e9f;
// Number of instances, where nested instances multiply, because a short file can request the product. A moving instance
// counts once for each time step of its motion (AnimatedTransform::steps, up to 65).
inline constexpr size_t kInstanceSteps = size_t(1) << 24;
// Triangles that all subdivision surfaces of a scene may be refined into: 64 per pixel of a one-megapixel picture,
// where one would do. They need about 11 GB once the BVH is built, and 30 GB more if they emit light.
inline constexpr double kSubdividedTriangles = 1 << 26;
// Pieces that all curves of a scene may be split into: ten million hairs of a dozen pieces each. They need about 24 GB,
// or 32 GB as ribbons. A curve segment that takes six bytes in the file may become 64 pieces.
inline constexpr size_t kCurvePieces = size_t(1) << 27;
// Surfaces of a lens. Every camera ray is intersected with all of them; the longest zoom lenses have about fifty.
inline constexpr size_t kLensSurfaces = 256;

// --- Pictures ------------------------------------------------------------------------------------------------------

// Width or height of an image: more than any camera or scan produces.
inline constexpr int kImageSide = 1 << 16;
// Pixels of an image: 32768 x 32768, the size of the largest published environment maps.
inline constexpr int64_t kImagePixels = int64_t(1) << 30;
// Channels of an EXR file. Production files have up to about two hundred.
inline constexpr int kImageChannels = 1024;
// Scans of a JPEG, each of which traverses the whole picture; progressive files have about ten.
inline constexpr int kJpegScans = 500;
// Width or height of the film. A film of kFilmSide squared exceeds the memory of machines (see MemoryClaim), but a crop
// window of it does not.
inline constexpr int kFilmSide = 1 << 16;
// Samples per pixel that a scene may ask for. Beyond this, adding one more sample to a float sum changes nothing.
inline constexpr int kSamplesPerPixel = 1 << 24;

}  // namespace drc::limits
