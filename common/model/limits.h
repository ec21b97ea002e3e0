#pragma once

#include <cstdint>
#include <string_view>

#include "common/geometry/point.h"

namespace slicefarm::limits {

/// Every bound on what a stranger may send stands here, and errors quote it (`limit`, `got`).

/// Of a file, and of all parts of a job: a mesh counts for each part that is made of it.
inline constexpr int64_t kMaxTriangles = 20'000'000;
inline constexpr int64_t kMaxMeshBytes = 2'000'000'000;
inline constexpr int64_t kMaxAsciiLineBytes = 1024;
inline constexpr int64_t kMaxFaceVertices = 1024;  ///< of one OBJ face
// Of a project file (3MF), which is an archive of files:
inline constexpr int64_t kMaxExpandedArchiveBytes = int64_t{2} << 30;
inline constexpr int64_t kMaxCompressionRatio = 200;
/// A file in the archive may be this large whatever its ratio: blanks compress a thousandfold.
inline constexpr int64_t kFreeExpandedBytes = 1 << 20;
inline constexpr int64_t kMaxArchiveEntries = 1'000;
inline constexpr int64_t kMaxMetadataBytes = 16 << 20;  ///< of one file of settings in it
inline constexpr int64_t kMaxXmlDepth = 64;
inline constexpr int64_t kMaxXmlTagBytes = 1 << 20;
inline constexpr int64_t kMaxComponentsDepth = 32;
inline constexpr int64_t kMaxFileResources = 100'000;  ///< objects and components of all its models
inline constexpr int64_t kMaxParts = 10'000;           ///< of all objects on the plates
inline constexpr int64_t kMaxHeightRanges = 1'000;     ///< of one object
inline constexpr int64_t kMaxPartRanges = 100'000;     ///< each part in each range of its object
inline constexpr int64_t kMaxProjectPlates = 1'000;
inline constexpr int64_t kMaxProjectBytes = 16 << 20;  ///< names and settings together
inline constexpr double kMaxTransformEntry = 1e6;      ///< a scale, or mm: plates lie side by side
inline constexpr double kMaxMeshCoordinateMm = 10'000;
inline constexpr Coord kMaxCoord = 2'100'000'000;  ///< a placed part fits in 32-bit nanometres
/// Of a machine, as profiles have it; what stands on it is within kMaxCoord.
inline constexpr Coord kMaxPrintHeight = 10'000'000'000;
inline constexpr int64_t kMaxLayers = 20'000;
/// Of all objects that are printed one after the other: each layer is a program of its own.
inline constexpr int64_t kMaxLayerPrograms = 200'000;
inline constexpr int64_t kMaxPointsPerLayer = 5'000'000;
/// Over all layers and parts of a job, before simplification; copies count once.
inline constexpr int64_t kMaxPointsPerJob = 200'000'000;
/// A job's result, G-code or vectors: what a spool and a store take for one job.
inline constexpr int64_t kMaxProgramBytes = 2'000'000'000;
inline constexpr int64_t kMaxObjects = 1'000;         ///< copies included
inline constexpr int64_t kMaxStacks = 4 * kMaxObjects + 1'000;  ///< parts and what is added
inline constexpr int64_t kMaxRegionSettings = 1'000;  ///< rows of a job's tables of settings
/// Texts of all sets of settings of a job: each range of heights, part or object with some of its
/// own has all of the job's as well, though long ones are shared.
inline constexpr int64_t kMaxResolvedBytes = 48 << 20;
inline constexpr int64_t kLongTextBytes = 1024;  ///< of a value: from here on it is shared
inline constexpr int32_t kMaxPerimeters = 10'000;
inline constexpr int32_t kMaxSkirtLoops = 500;
inline constexpr int32_t kMaxRaftLayers = 100;
/// Of a milling job: its levels and rows; what a step weighs.
inline constexpr int64_t kMaxMillSteps = 200'000;
inline constexpr int32_t kMaxMillWeight = 1'000;
/// Of a surface that is engraved, and of a texture that is an object: each travels as one message.
inline constexpr int64_t kMaxSurfaceTriangles = 1'000'000;
inline constexpr int64_t kMaxSurfacePoints = 2'000'000;
inline constexpr int64_t kMaxLinesPerFill = 200'000;
inline constexpr int32_t kMaxThumbnails = 8;
inline constexpr int32_t kMaxThumbnailPx = 1'024;
inline constexpr int64_t kMaxStageMessageBytes = 64 << 20;  ///< between stages, one layer a message
/// Of what the calls of a job have in common: one value, such as its settings, and all that a
/// server keeps at a time, of whatever jobs.
inline constexpr int64_t kMaxSharedBytes = 1 << 30;
inline constexpr int64_t kMaxKeptSharedBytes = 256 << 20;
inline constexpr int64_t kSharedPieceBytes = 1 << 20;
inline constexpr int64_t kMaxPublicMessageBytes = 4 << 20;
inline constexpr int64_t kUploadChunkBytes = 64 << 10;  ///< as our programs send
inline constexpr int64_t kMaxUploadChunkBytes = 1 << 20;  ///< as others may
inline constexpr int64_t kMaxSettingBytes = 64 << 10;  ///< one value, such as a start G-code
/// What a G-code template, or a text within it, may come to: a layer's stays far below a message.
inline constexpr int64_t kMaxExpandedBytes = 1 << 20;
/// A field of density, stress or materials, which is a setting as well; it fits in a job's spec.
inline constexpr int64_t kMaxFieldBytes = 768 << 10;
inline constexpr int64_t kMaxFieldValues = 200'000;  ///< nodes of a field's grid
inline constexpr size_t kMaxMixedMaterials = 6;      ///< that one mixing extruder takes in
inline constexpr int64_t kMaxFieldHaloLayers = 100;  ///< that a field by surface distance looks at
inline constexpr int64_t kMaxSettings = 2'000;
inline constexpr int64_t kMaxNameBytes = 255;      ///< of an object, a request id
inline constexpr int64_t kMaxSpecBytes = 1 << 20;  ///< of a job: it is echoed in one message
inline constexpr int64_t kMaxPlatesBytes = 64 * kMaxSpecBytes;  ///< of all plates of one call
inline constexpr int64_t kMaxLabels = 64;
inline constexpr int64_t kMaxLabelBytes = 1024;  ///< key and value together
inline constexpr int32_t kMaxPageSize = 1'000;
inline constexpr int32_t kMaxBatchJobs = 100;  ///< made by one call
inline constexpr int32_t kMaxJobProfiles = 16;
inline constexpr int64_t kMaxProfileRevisions = 10'000;  ///< of a tenant
inline constexpr int64_t kMaxUrlBytes = 2'048;
inline constexpr int64_t kMaxOpenJobs = 10'000;  ///< of a tenant, waiting and running

/// Of a setting, by its name: fields hold a grid's values, images a file.
constexpr int64_t MaxSettingBytes(std::string_view key) {
  const bool is_long = key.ends_with("_field") || key.ends_with("_image");
  return is_long ? kMaxFieldBytes : kMaxSettingBytes;
}

}  // namespace slicefarm::limits
