#include "link/linkmap.h"

#include "model/plain/uvseams.h"

#include <algorithm>

namespace autocuts::link {

using namespace Qt::Literals::StringLiterals;

namespace {

//! Per edge pair: it is a seam of the map.
std::vector<bool> seamsOf(const MeshData &mesh, const UvMatrix &uv)
{
    const std::vector<bool> open = openCornerPairs(mesh, uv);
    std::vector<bool> seams(mesh.edgePairs.size());
    for (std::size_t pair = 0; pair < seams.size(); ++pair)
        seams[pair] = open[2 * pair] || open[2 * pair + 1];
    return seams;
}

QByteArray mapMessage(const SharedModel &model, const MapToSend &send)
{
    Message message(u"maps"_s);
    message.set(u"serial"_s, model.serial);
    message.set(u"uvSet"_s, send.uvSet);
    message.set(u"solving"_s, send.solving);
    UvMatrix uv = send.uv;
    uv.col(1) /= send.tileHeight;
    message.add(u"uvs"_s, std::span<const double>(uv.data(), std::size_t(uv.size())), 2);
    std::vector<int> ends;
    for (const VertexPair &edge : model.edges->names(seamsOf(*model.mesh, send.uv)))
        ends.insert(ends.end(), edge.begin(), edge.end());
    message.add(u"seams"_s, std::span<const int>(ends), 2);
    return message.encoded();
}

} // namespace

LinkUvs toLinkUvs(const UvMatrix &uv, double tileHeight)
{
    LinkUvs result(uv.rows(), 2);
    result.col(0) = uv.col(0).cast<float>();
    result.col(1) = (uv.col(1) / tileHeight).cast<float>();
    return result;
}

bool sameUvs(const LinkUvs &a, const LinkUvs &b)
{
    return a.size() == b.size() && std::equal(a.data(), a.data() + a.size(), b.data(),
                                              [](float x, float y) { return x == y || (x != x && y != y); });
}

Marks marksOf(const VertexPairs &edges, const MapToSend &send)
{
    std::vector<bool> cut(send.states.size() / 2);
    for (std::size_t pair = 0; pair < cut.size(); ++pair)
        cut[pair] = send.states[2 * pair] == PairState::Cut && send.states[2 * pair + 1] == PairState::Cut;
    Marks marks{edges.names(cut), {}, send.faces};
    for (const UvPin &pin : send.pins)
        marks.pins.push_back(
            {pin.corner, float(pin.position.x()), float(pin.position.y() / send.tileHeight)});
    return marks;
}

QByteArray messagesFor(SharedModel &model, const MapToSend &send)
{
    QByteArray frames;
    const Marks marks = marksOf(*model.edges, send);
    if (const MarkChanges changes = model.marks.changesTo(marks); !changes.isEmpty()) {
        Message message(u"marks"_s);
        message.set(u"serial"_s, model.serial);
        changes.writeTo(message);
        frames += message.encoded();
        model.marks = marks;
    }
    if (!send.textures.isEmpty() && send.textures != model.textures) {
        Message message(u"textures"_s);
        message.set(u"serial"_s, model.serial);
        message.set(u"materials"_s, send.textures);
        frames += message.encoded();
        model.textures = send.textures;
    }
    const bool none = !(send.uv.array() == send.uv.array()).any();
    if (none && !send.always)
        return frames;
    LinkUvs uvs = toLinkUvs(send.uv, send.tileHeight);
    if (send.always || send.solving != model.solving || !sameUvs(uvs, model.uvs)) {
        frames += mapMessage(model, send);
        model.uvs = std::move(uvs);
        model.solving = send.solving;
    }
    return frames;
}

} // namespace autocuts::link
