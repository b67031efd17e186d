#include "model/layouts/report.h"

#include <array>
#include <charconv>
#include <cmath>

namespace autocuts {

namespace {

QByteArray jsonText(const QString &text)
{
    QByteArray result = "\"";
    const QByteArray utf8 = text.toUtf8();
    for (const char c : utf8) {
        if (c == '"' || c == '\\') {
            result += '\\';
            result += c;
        } else if (c == '\n') {
            result += "\\n";
        } else if (static_cast<unsigned char>(c) < 0x20) {
            result += "\\u00" + QByteArray(1, c).toHex();
        } else {
            result += c;
        }
    }
    return result + '"';
}

QByteArray jsonNumber(double value)
{
    if (!std::isfinite(value))
        return "null";
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), static_cast<qsizetype>(end - text.data())};
}

QByteArray jsonCount(const MapReport::Count &count)
{
    return count ? QByteArray::number(*count) : QByteArray("null");
}

//! Writes a JSON object, key by key.
class ObjectWriter
{
public:
    explicit ObjectWriter(int depth) : mIndent(2 * (depth + 1), ' ') {}

    void add(const char *key, double value) { addRaw(key, jsonNumber(value)); }
    void add(const char *key, const MapReport::Count &value) { addRaw(key, jsonCount(value)); }
    void add(const char *key, int value) { addRaw(key, QByteArray::number(value)); }
    void add(const char *key, const std::optional<bool> &value)
    {
        addRaw(key, value ? (*value ? "true" : "false") : "null");
    }
    //! An empty string is written as null.
    void add(const char *key, const QString &value)
    {
        addRaw(key, value.isEmpty() ? "null" : jsonText(value));
    }
    void addRaw(const char *key, const QByteArray &value)
    {
        mText += mText.isEmpty() ? "{\n" : ",\n";
        mText += mIndent + '"' + key + "\": " + value;
    }
    QByteArray finish() const { return mText + '\n' + mIndent.chopped(2) + '}'; }

private:
    QByteArray mIndent;
    QByteArray mText;
};

QByteArray meshJson(const std::optional<MeshReport> &mesh)
{
    if (!mesh)
        return "null";
    ObjectWriter writer(1);
    writer.add("vertices", mesh->vertices);
    writer.add("welded_vertices", mesh->weldedVertices);
    writer.add("isolated_vertices", mesh->isolatedVertices);
    writer.add("faces", mesh->faces);
    writer.add("polygons", mesh->polygons);
    writer.add("concave_polygons", mesh->concavePolygons);
    writer.add("self_contact_polygons", static_cast<int>(mesh->selfContactFaces.size()));
    writer.add("objects", mesh->objects);
    writer.add("components", mesh->components);
    writer.add("degenerate_triangles", mesh->degenerateTriangles);
    writer.add("duplicate_faces", mesh->duplicateFaces);
    writer.add("boundary_edges", mesh->boundaryEdges);
    writer.add("nonmanifold_edges", mesh->nonManifoldEdges);
    writer.add("winding_edges", mesh->windingEdges);
    writer.add("area", mesh->area);
    writer.add("box_diagonal", mesh->boxDiagonal);
    writer.add("distance_from_origin", mesh->distanceFromOrigin);
    return writer.finish();
}

QByteArray transferJson(const std::optional<transfer::TransferFigures> &figures)
{
    if (!figures)
        return "null";
    ObjectWriter writer(1);
    writer.add("faces", figures->faces);
    writer.add("copied", figures->copied);
    writer.add("placed", figures->placed);
    writer.add("unmatched", figures->unmatched());
    writer.add("mean_distance", figures->meanDistance);
    writer.add("max_distance", figures->maxDistance);
    writer.add("turned_over", figures->turnedOver);
    writer.add("collapsed", figures->collapsed);
    writer.add("seam_length", figures->seamLength);
    writer.add("source_seam_length", figures->sourceSeamLength);
    return writer.finish();
}

//! \param textOf gives the JSON of an item
template <class Items, class TextOf>
QByteArray listJson(const Items &items, TextOf textOf)
{
    QByteArray text = "[";
    for (const auto &item : items)
        text += (text.size() > 1 ? ",\n    " : "\n    ") + textOf(item);
    return items.empty() ? QByteArray("[]") : text + "\n  ]";
}

QByteArray partJson(const MapReport::Part &part)
{
    ObjectWriter writer(2);
    writer.add("name", part.name);
    writer.add("faces", MapReport::Count(part.faces));
    writer.add("charts", MapReport::Count(part.charts));
    writer.add("sym_dirichlet", part.symDirichlet);
    writer.add("texel_density", part.texelDensity);
    writer.add("packing_efficiency", part.packingEfficiency);
    return writer.finish();
}

QByteArray tileJson(const MapReport::Tile &tile)
{
    ObjectWriter writer(2);
    writer.add("tile", tile.number);
    writer.add("faces", MapReport::Count(tile.faces));
    writer.add("charts", MapReport::Count(tile.charts));
    writer.add("texel_density", tile.texelDensity);
    writer.add("packing_efficiency", tile.packingEfficiency);
    return writer.finish();
}

QByteArray offTileJson(const MapReport::OffTile &island)
{
    ObjectWriter writer(2);
    writer.add("island", island.island);
    writer.add("tile", island.tile);
    return writer.finish();
}

void addStableKeys(ObjectWriter &writer, const MapReport &report)
{
    writer.add("triangles", report.triangles);
    writer.add("charts", report.charts);
    writer.add("seam_length", report.seamLength);
    writer.add("seam_norm", report.seamNorm);
    writer.add("sym_dirichlet", report.symDirichlet);
    writer.add("sym_dirichlet_max", report.symDirichletMax);
    writer.add("flipped", report.flipped);
    writer.add("overlap_pairs", report.overlapPairs);
    writer.add("overlap_area_ratio", report.overlapAreaRatio);
    writer.add("packing_efficiency", report.packingEfficiency);
    writer.add("min_gutter_texels", report.minGutterTexels);
    writer.add("seconds", report.seconds);
    writer.add("iterations", report.iterations);
    writer.add("lambda", report.lambda);
    writer.add("delta", report.delta);
    writer.add("status", report.status);
}

void addFurtherKeys(ObjectWriter &writer, const MapReport &report)
{
    writer.add("hard_surface_share", report.hardSurfaceShare);
    writer.add("input", report.input);
    writer.add("output", report.output);
    writer.add("layout", report.layout);
    writer.add("uv_set", report.uvSet);
    writer.add("texture_size", report.textureSize);
    writer.add("texture_height", report.textureHeight);
    writer.add("faces", report.faces);
    writer.add("faces_without_uv", report.facesWithoutUv);
    writer.add("faces_without_uv_area", report.facesWithoutUvArea);
    writer.add("zero_area_triangles", report.zeroAreaTriangles);
    writer.add("non_disk_charts", report.nonDiskCharts);
    writer.add("mirrored_charts", report.mirroredCharts);
    writer.add("seam_edges", report.seamEdges);
    writer.add("uv_degenerate", report.uvDegenerate);
    writer.add("overlapping_triangles", report.overlappingTriangles);
    writer.add("stacked_pairs", report.stackedPairs);
    writer.add("sym_dirichlet_p99", report.symDirichletP99);
    writer.add("sym_dirichlet_infinite", report.symDirichletInfinite);
    writer.add("sym_dirichlet_tiles", report.symDirichletTiles);
    writer.add("sym_dirichlet_scale", report.symDirichletScale);
    writer.add("l2_stretch", report.l2Stretch);
    writer.add("angle_distortion", report.angleDistortion);
    writer.add("area_distortion", report.areaDistortion);
    writer.add("texel_density_spread", report.texelDensitySpread);
    writer.add("texel_density_weights", report.texelDensityWeights);
    writer.add("axis_aligned_share", report.axisAlignedShare);
    writer.add("packing_bbox", report.packingBox);
    writer.add("min_gutter", report.minGutter);
    writer.add("border_gutter_texels", report.borderGutterTexels);
    writer.add("in_unit_square", report.inUnitSquare);
    writer.add("in_tiles", report.inTiles);
}

} // namespace

QByteArray reportJson(const MapReport &report)
{
    ObjectWriter writer(0);
    addStableKeys(writer, report);
    addFurtherKeys(writer, report);
    writer.addRaw("objects", listJson(report.objects, partJson));
    writer.addRaw("materials", listJson(report.materials, partJson));
    writer.addRaw("tiles", listJson(report.tiles, tileJson));
    writer.addRaw("islands_off_tile", listJson(report.offTile, offTileJson));
    writer.addRaw("mesh", meshJson(report.mesh));
    writer.addRaw("transfer", transferJson(report.transfer));
    writer.addRaw("notes", listJson(report.notes, jsonText));
    return writer.finish() + '\n';
}

} // namespace autocuts
