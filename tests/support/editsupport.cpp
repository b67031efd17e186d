#include "support/editsupport.h"

#include "model/plain/uvlayout.h"

namespace autocuts::test {

using namespace Qt::Literals::StringLiterals;

Scene sceneOf(const MeshPtr &mesh)
{
    Scene scene;
    scene.path = u"sample.obj"_s;
    scene.format = u"obj"_s;
    scene.mesh = mesh;
    scene.objectNames = {u"sample"_s};
    scene.faceMaterial.assign(mesh->faceCount(), -1);
    return scene;
}

UvMatrix splitLayout(const MeshData &mesh)
{
    UvMatrix uv(mesh.cornerCount(), 2);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const int start = mesh.faceStart[f];
        const int end = mesh.faceStart[f + 1];
        double centre = 0;
        for (int c = start; c < end; ++c)
            centre += mesh.cornerPosition(c).x() / (end - start);
        for (int c = start; c < end; ++c) {
            const Vec3 p = mesh.cornerPosition(c);
            uv.row(c) << p.x() + (centre > 0.5 ? 1.0 : 0.0), p.y();
        }
    }
    return uv;
}

std::unique_ptr<Document> layoutDocument(const MeshPtr &mesh)
{
    Scene scene = sceneOf(mesh);
    scene.uvSets.push_back({u"first"_s, splitLayout(*mesh)});
    scene.uvSets.push_back({u"lightmap"_s, emptyLayout(*mesh)});
    return std::make_unique<Document>(std::move(scene));
}

std::unique_ptr<Document> gridDocument()
{
    DocumentState state = layoutDocument(grid(4))->state();
    const MeshData &mesh = *state.scene.mesh;
    for (int edge = 0, marked = 0; marked < 3; ++edge) {
        if (mesh.edgePairs[edge].diagonal)
            continue;
        state.seams.states[2 * edge] = PairState::Joined;
        state.seams.weights[2 * edge + 1] = 2.5;
        ++marked;
    }
    state.seams.straight[66] = state.seams.straight[67] = 1;
    state.constraints.pins = {{3, {0.25, 0.5}, true, 1}, {40, {1.5, 0.5}, false, 7}};
    state.constraints.rectangles = {{1, u"head"_s, 0xff00ff00, {0, 0}, {0.5, 0.5}, false, 1, {0, 1, 4}},
                                    {4, u"hand"_s, 0xffff0000, {0.5, 0}, {1, 0.25}, true, 2, {}}};
    state.marks.faceFlags[2].locked = 1;
    state.marks.tags = {{u"skin"_s, {0, 1, 4, 5}}};
    state.selection.faces = {1, 2, 3};
    state.viewState = QByteArrayLiteral("camera");
    return std::move(*Document::create(std::move(state)).operator->());
}

namespace {

QString rangesText(const IndexRanges &ranges)
{
    QStringList parts;
    for (const IndexRange &range : ranges.ranges())
        parts.append(u"%1-%2"_s.arg(range.first).arg(range.end - 1));
    return parts.join(u',');
}

QString eventText(const ChangeEvent &event)
{
    switch (event.type) {
    case ChangeEvent::Type::Model:
        return u"model"_s;
    case ChangeEvent::Type::Uv: {
        const auto &e = static_cast<const UvEvent &>(event);
        return u"uv %1 set %2: %3"_s.arg(e.properties).arg(e.uvSet).arg(rangesText(e.corners)).trimmed();
    }
    case ChangeEvent::Type::UvSet: {
        const auto &e = static_cast<const UvSetEvent &>(event);
        return u"set %1 %2"_s.arg(static_cast<int>(e.change)).arg(e.index);
    }
    case ChangeEvent::Type::Seam: {
        const auto &e = static_cast<const SeamEvent &>(event);
        return u"seam %1: %2"_s.arg(e.properties).arg(rangesText(e.cornerPairs));
    }
    case ChangeEvent::Type::Pin:
        return u"pin %1"_s.arg(rangesText(static_cast<const PinEvent &>(event).corners));
    case ChangeEvent::Type::Rectangle: {
        const auto &e = static_cast<const RectangleEvent &>(event);
        return u"rectangle %1: %2"_s.arg(e.id).arg(e.properties);
    }
    case ChangeEvent::Type::IslandFlag: {
        const auto &e = static_cast<const IslandFlagEvent &>(event);
        return u"flag %1: %2"_s.arg(e.properties).arg(rangesText(e.faces));
    }
    case ChangeEvent::Type::Tag:
        return u"tag %1"_s.arg(static_cast<const TagEvent &>(event).name);
    case ChangeEvent::Type::Hidden:
        return u"hidden"_s;
    case ChangeEvent::Type::Textures:
        return u"textures"_s;
    case ChangeEvent::Type::SharedMeshes:
        return u"shared meshes"_s;
    case ChangeEvent::Type::SolveSettings:
        return u"solve %1"_s.arg(static_cast<const SolveSettingsEvent &>(event).properties);
    case ChangeEvent::Type::PackingSettings:
        return u"packing %1"_s.arg(static_cast<const PackingSettingsEvent &>(event).properties);
    case ChangeEvent::Type::TexelWeight:
        return u"texels %1"_s.arg(rangesText(static_cast<const TexelWeightEvent &>(event).faces));
    }
    return u"unknown"_s;
}

} // namespace

EventLog::EventLog(Document &document)
{
    connect(&document, &Document::changed, this,
            [this](const ChangeEvent &event) { mLines.append(eventText(event)); });
}

QStringList EventLog::take()
{
    return std::exchange(mLines, {});
}

DocumentState withoutSelection(DocumentState state)
{
    state.selection = {};
    return state;
}

} // namespace autocuts::test
