#pragma once

#include <cstdint>
#include <string_view>

#include "common/geometry/point.h"

namespace slicefarm::limits {

// All limits on untrusted input are defined in this file. Errors quote them (`limit`, `got`).

/// Limits of a mesh file, and of all parts of a job together. A mesh counts once for each part that
/// uses it.
inline constexpr int64_t kMaxTriangles = 20'000'000;
inline constexpr int64_t kMaxMeshBytes = 2'000'000'000;
inline constexpr int64_t kMaxAsciiLineBytes = 1024;
inline constexpr int64_t kMaxFaceVertices = 1024;  ///< vertices of one OBJ face
// Limits of a project file (3MF), which is an archive of files.
inline constexpr int64_t kMaxExpandedArchiveBytes = int64_t{2} << 30;
inline constexpr int64_t kMaxCompressionRatio = 200;
/// Size of a file in the archive up to which its compression ratio is not limited, because blanks
/// can be compressed to a thousandth.
inline constexpr int64_t kFreeExpandedBytes = 1 << 20;
inline constexpr int64_t kMaxArchiveEntries = 1'000;
/// Size of one settings file in the archive.
inline constexpr int64_t kMaxMetadataBytes = 16 << 20;
inline constexpr int64_t kMaxXmlDepth = 64;
inline constexpr int64_t kMaxXmlTagBytes = 1 << 20;
inline constexpr int64_t kMaxComponentsDepth = 32;
/// Objects and components of all models of a file.
inline constexpr int64_t kMaxFileResources = 100'000;
inline constexpr int64_t kMaxParts = 10'000;        ///< parts of all objects on the plates
inline constexpr int64_t kMaxHeightRanges = 1'000;  ///< height ranges of one object
/// Pairs of a part and a height range of its object.
inline constexpr int64_t kMaxPartRanges = 100'000;
inline constexpr int64_t kMaxProjectPlates = 1'000;
inline constexpr int64_t kMaxProjectBytes = 16 << 20;  ///< size of names and settings together
/// Element of a transform: scale factor, or shift in mm. Large, because the plates of a project are
/// side by side.
inline constexpr double kMaxTransformEntry = 1e6;
inline constexpr double kMaxMeshCoordinateMm = 10'000;
/// Coordinate of a placed part; it fits in 32-bit nanometres.
inline constexpr Coord kMaxCoord = 2'100'000'000;
/// Print height of a machine in a profile, in nm. The parts themselves are limited by kMaxCoord.
inline constexpr Coord kMaxPrintHeight = 10'000'000'000;
inline constexpr int64_t kMaxLayers = 20'000;
/// Total number of layers of all passes. In sequential printing, each layer of each object is a
/// separate program.
inline constexpr int64_t kMaxLayerPrograms = 200'000;
inline constexpr int64_t kMaxPointsPerLayer = 5'000'000;
/// Points of the outlines of all layers and parts of a job, before simplification. Copies of an
/// object count once.
inline constexpr int64_t kMaxPointsPerJob = 200'000'000;
/// Facets of the upper side (Z contouring) in a layer of an object, and in all layers of a job. A
/// face counts in each layer that it reaches.
inline constexpr int64_t kMaxFacetsPerLayer = 5'000'000;
inline constexpr int64_t kMaxFacetsPerJob = 50'000'000;
/// Size of a job's result, G-code or vectors, that a spool and a store accept.
inline constexpr int64_t kMaxProgramBytes = 2'000'000'000;
inline constexpr int64_t kMaxObjects = 1'000;  ///< objects, copies included
/// stacks (stack.h): parts of objects, and stacks that planning adds
inline constexpr int64_t kMaxStacks = 4 * kMaxObjects + 1'000;
inline constexpr int64_t kMaxRegionSettings = 1'000;  ///< rows of a job's tables of region settings
/// Size of all resolved settings of a job. Each height range, part or object with settings of its
/// own has a full copy of the job's settings; only long texts are shared.
inline constexpr int64_t kMaxResolvedBytes = 48 << 20;
inline constexpr int64_t kLongTextBytes = 1024;  ///< length from which a setting's text is shared
inline constexpr int32_t kMaxPerimeters = 10'000;
inline constexpr int32_t kMaxSkirtLoops = 500;
inline constexpr int32_t kMaxRaftLayers = 100;
/// Limits of a milling job: its steps (levels and rows), and the weight of one step.
inline constexpr int64_t kMaxMillSteps = 200'000;
inline constexpr int32_t kMaxMillWeight = 1'000;
/// Limits of an engraved surface and of a texture object. Each of them is sent as one message.
inline constexpr int64_t kMaxSurfaceTriangles = 1'000'000;
inline constexpr int64_t kMaxSurfacePoints = 2'000'000;
inline constexpr int64_t kMaxLinesPerFill = 200'000;
inline constexpr int32_t kMaxThumbnails = 8;
inline constexpr int32_t kMaxPlatePictures = 8;  ///< pictures for an archive, besides thumbnails
inline constexpr int32_t kMaxThumbnailPx = 1'024;
/// Size of a message between stages; a message contains one layer.
inline constexpr int64_t kMaxStageMessageBytes = 64 << 20;
/// Size of one value that the calls of a job share, such as the settings. kMaxKeptSharedBytes: size
/// of all shared values of all jobs that a server stores at a time.
inline constexpr int64_t kMaxSharedBytes = 1 << 30;
inline constexpr int64_t kMaxKeptSharedBytes = 256 << 20;
inline constexpr int64_t kSharedPieceBytes = 1 << 20;
inline constexpr int64_t kMaxPublicMessageBytes = 4 << 20;
/// upload chunk that slicefarm's own programs send
inline constexpr int64_t kUploadChunkBytes = 64 << 10;
/// Upload chunk that other clients may send.
inline constexpr int64_t kMaxUploadChunkBytes = 1 << 20;
/// Size of the value of one setting, such as a start G-code.
inline constexpr int64_t kMaxSettingBytes = 64 << 10;
/// Size of an expanded G-code template, or of a text within it. A layer with an expanded template
/// remains far below kMaxStageMessageBytes.
inline constexpr int64_t kMaxExpandedBytes = 1 << 20;
/// Size of a field of density, stress or materials. A field is a setting and fits in a job's spec.
inline constexpr int64_t kMaxFieldBytes = 768 << 10;
inline constexpr int64_t kMaxFieldValues = 200'000;  ///< nodes of a field's grid
inline constexpr size_t kMaxMixedMaterials = 6;      ///< materials of one mixing extruder
/// Number of layers above and below a layer that a field needs, if its density depends on the
/// distance to the surface.
inline constexpr int64_t kMaxFieldHaloLayers = 100;
inline constexpr int64_t kMaxSettings = 2'000;
inline constexpr int64_t kMaxNameBytes = 255;  ///< length of an object's name or a request id
/// Size of a job's spec, because the service returns the spec in one message.
inline constexpr int64_t kMaxSpecBytes = 1 << 20;
inline constexpr int64_t kMaxPlatesBytes = 64 * kMaxSpecBytes;  ///< size of all plates of one call
inline constexpr int64_t kMaxLabels = 64;
inline constexpr int64_t kMaxLabelBytes = 1024;  ///< length of key and value together
inline constexpr int32_t kMaxPageSize = 1'000;
inline constexpr int32_t kMaxBatchJobs = 100;  ///< jobs created by one call
inline constexpr int32_t kMaxJobProfiles = 16;
inline constexpr int64_t kMaxProfileRevisions = 10'000;  ///< profile revisions of a tenant
inline constexpr int64_t kMaxPresetRevisions = 1'000;  ///< revisions of preset bundles of a tenant
inline constexpr int64_t kMaxPresetStoreBytes = 256 << 20;  ///< stored bytes of these revisions
inline constexpr int64_t kMaxPresetBundles = 200;           ///< bundles that a job may use
/// Bytes of all preset files of a job, and of one bundle, expanded.
inline constexpr int64_t kMaxJobPresetBytes = 64 << 20;
inline constexpr int64_t kMaxUrlBytes = 2'048;
inline constexpr int64_t kMaxOpenJobs = 10'000;  ///< waiting and running jobs of a tenant

/// Returns the size limit for the value of the setting `key`. Keys that end in _field or _image
/// have a larger limit, because their values contain a grid or a file.
constexpr int64_t MaxSettingBytes(std::string_view key) {
  const bool is_long = key.ends_with("_field") || key.ends_with("_image");
  return is_long ? kMaxFieldBytes : kMaxSettingBytes;
}

}  // namespace slicefarm::limits
