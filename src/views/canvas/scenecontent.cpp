#include "views/canvas/scenecontent.h"

#include "model/document/givenseams.h"
#include "model/plain/flippedtriangles.h"
#include "model/plain/uvlayout.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/session/shownmap.h"
#include "views/control/session/workspace.h"
#include "views/gl/buried.h"
#include "views/gl/meshdrawing.h"
#include "views/gl/texeldensity.h"
#include "views/ui/preferences.h"

#include <cmath>

namespace autocuts {

//! Data made once per mesh.
struct SceneContent::MeshParts
{
    explicit MeshParts(std::shared_ptr<const MeshDrawing> d) : drawing(std::move(d)), mesh(drawing->mesh) {}

    std::shared_ptr<const MeshDrawing> drawing;
    std::shared_ptr<const MeshData> mesh;
};

SceneContent::SceneContent(const StudioContext &context, bool asMap, QObject *parent)
    : QObject(parent), mContext(context), mAsMap(asMap),
      mColors(ViewColors::of(context.preferences.values(), asMap)), mOptions(context.view.options())
{
    if (const Document *document = context.workspace.document())
        mSelection = document->selection();
    connectAll();
}

SceneContent::~SceneContent() = default;

void SceneContent::connectAll()
{
    connect(&mContext.workspace, &Workspace::documentReplaced, this, [this] {
        mMeshParts.reset();
        mShownUv.resize(0, 2);
        const Document *document = mContext.workspace.document();
        mSelection = document ? document->selection() : Selection();
        markAll();
    });
    connect(&mContext.workspace, &Workspace::changed, this, &SceneContent::documentChanged);
    connect(&mContext.workspace, &Workspace::selectionChanged, this, &SceneContent::selectionChanged);
    connect(&mContext.shownMap, &ShownMap::changed, this, [this] {
        mShownUv.resize(0, 2);
        mark(Uvs | Faces | Sides | (mAsMap ? Points | Ghost : 0));
    });
    if (mAsMap)
        connect(&mContext.shownMap, &ShownMap::ghostChanged, this, [this] { mark(Ghost); });
    connect(&mContext.view, &ViewState::optionsChanged, this, &SceneContent::optionsChanged);
    connect(&mContext.view, &ViewState::hoverChanged, this, &SceneContent::changed);
    connect(&mContext.preferences, &Preferences::changed, this, &SceneContent::preferencesChanged);
    connect(&mContext.map, &MapController::figuresChanged, this, [this] {
        if (mOptions.problems)
            mark(Faces);
    });
}

void SceneContent::mark(int parts)
{
    mStale |= parts | ((parts & Faces) && showsStretch() ? Measures : 0);
    Q_EMIT changed();
}

void SceneContent::markAll()
{
    mCanBeDrawn = false;
    mRound = mMade = 0;
    mark(AllParts);
}

void SceneContent::documentChanged(const ChangeEvent &event)
{
    switch (event.type) {
    case ChangeEvent::Type::Seam: {
        const int properties = static_cast<const SeamEvent &>(event).properties;
        const bool painted = mOptions.coloring == Coloring::PaintWeights && (properties & SeamEvent::Weight);
        const bool lines = properties & (SeamEvent::State | SeamEvent::Straight);
        if (lines || painted)
            mark((lines ? Sides : 0) | (painted ? Faces : 0));
        break;
    }
    case ChangeEvent::Type::Pin:
        mark(Points);
        break;
    case ChangeEvent::Type::Rectangle:
    case ChangeEvent::Type::IslandFlag:
    case ChangeEvent::Type::Tag:
        mark(0); // they are drawn over the map
        break;
    case ChangeEvent::Type::PackingSettings: // texels may have another size
        mark(mOptions.coloring == Coloring::Density ? Faces : 0);
        break;
    case ChangeEvent::Type::TexelWeight:
        mark(showsTexelWeights() ? Faces : 0);
        break;
    case ChangeEvent::Type::Model: // the workspace says that the document was replaced
    case ChangeEvent::Type::Uv:    // ShownMap reports the change when the map is shown
    case ChangeEvent::Type::UvSet:
    case ChangeEvent::Type::SharedMeshes:
    case ChangeEvent::Type::Textures: // ModelPictures reads them
        break;
    case ChangeEvent::Type::Hidden:
        mShownUv.resize(0, 2);
        mark(Uvs | Faces | Points);
        break;
    case ChangeEvent::Type::SolveSettings:
        if (changesGivenSeams(event))
            mark(Sides);
        break;
    }
}

//! True when the colours of the faces depend on the texel weights.
bool SceneContent::showsTexelWeights() const
{
    return mOptions.coloring == Coloring::TexelWeights || mOptions.coloring == Coloring::Density ||
           showsStretch();
}

bool SceneContent::showsStretch() const
{
    return mOptions.coloring == Coloring::SignedStretch || mOptions.coloring == Coloring::StretchMagnitude;
}

void SceneContent::selectionChanged()
{
    const Document *document = mContext.workspace.document();
    const Selection selection = document ? document->selection() : Selection();
    mark((selection.faces != mSelection.faces ? Faces : 0) |
         (selection.edges != mSelection.edges ? Sides : 0) |
         (selection.corners != mSelection.corners ? Points : 0));
    mSelection = selection;
}

void SceneContent::optionsChanged()
{
    const ViewOptions before = std::exchange(mOptions, mContext.view.options());
    int parts = 0;
    if (before.coloring != mOptions.coloring || before.problems != mOptions.problems ||
        before.stretchClamp != mOptions.stretchClamp || before.magnitudeClamp != mOptions.magnitudeClamp ||
        before.densityClamp != mOptions.densityClamp || before.densityTarget != mOptions.densityTarget ||
        before.densityTolerance != mOptions.densityTolerance)
        parts |= Faces;
    if (before.wireframe != mOptions.wireframe || before.seams != mOptions.seams)
        parts |= Sides;
    if (before.steering != mOptions.steering)
        parts |= Sides | Points;
    mark(parts);
}

void SceneContent::preferencesChanged()
{
    mColors = ViewColors::of(mContext.preferences.values(), mAsMap);
    mark(Faces | Points);
}

const MeshData *SceneContent::mesh() const
{
    const Document *document = mContext.workspace.document();
    return document ? &document->mesh() : nullptr;
}

const SceneContent::MeshParts &SceneContent::meshParts() const
{
    // Compared because a canvas can be used before it has been told about another document.
    const std::shared_ptr<const MeshData> &current = mContext.workspace.document()->state().scene.mesh;
    if (!mMeshParts || mMeshParts->mesh != current)
        mMeshParts = std::make_unique<const MeshParts>(mContext.workspace.drawing());
    return *mMeshParts;
}

std::shared_ptr<const MeshData> SceneContent::sharedMesh() const
{
    return meshParts().mesh;
}

const MeshFrame &SceneContent::frame() const
{
    return meshParts().drawing->frame;
}

const SoupTopology &SceneContent::topology() const
{
    return meshParts().drawing->topology;
}

const UvMatrix &SceneContent::uv() const
{
    const UvMatrix &all = mContext.shownMap.uv();
    const Document *document = mContext.workspace.document();
    // While another document is being opened, the map may still be the old one.
    if (!document || document->hidden().empty() || all.rows() != document->mesh().soupCornerCount())
        return all;
    if (mShownUv.rows() != all.rows()) {
        mShownUv = all;
        const std::vector<bool> &hidden = document->hidden();
        const std::vector<int> &triangleFace = document->mesh().triangleFace;
        for (Eigen::Index s = 0; s < all.rows(); ++s) {
            if (hidden[triangleFace[s / 3]])
                mShownUv.row(s).setConstant(std::numeric_limits<double>::quiet_NaN());
        }
    }
    return mShownUv;
}

bool SceneContent::isHidden(int soupCorner) const
{
    const Document &document = *mContext.workspace.document();
    return !document.hidden().empty() && document.hidden()[document.mesh().triangleFace[soupCorner / 3]];
}

bool SceneContent::isLarge() const
{
    return mesh() && mesh()->triangleCount() > mostTrianglesAtOnce;
}

const std::vector<SoupVertex> &SceneContent::vertices() const
{
    return mAsMap || !mMeshParts ? mVertices : mMeshParts->drawing->vertices;
}

int SceneContent::refresh()
{
    const int stale = std::exchange(mStale, 0);
    mRound = 0;
    mCanBeDrawn = true;
    update(stale);
    return stale | std::exchange(mMade, 0);
}

int SceneContent::refreshOne()
{
    if (mRound == 0)
        mRound = mStale;
    const int part = mRound & -mRound; // the first
    mRound &= ~part;
    mStale &= ~part;
    mMade |= part;
    update(part);
    if (mRound != 0)
        return 0;
    mCanBeDrawn = true;
    return std::exchange(mMade, 0);
}

void SceneContent::update(int parts)
{
    const Document *document = mContext.workspace.document();
    if (!document) {
        mVertices.clear();
        mUvs.clear();
        mGhostUvs.clear();
        mUvBox.setEmpty();
        mFaces.clear();
        mTriangleIslands.clear();
        mSides.clear();
        mPoints.clear();
        return;
    }
    const MeshParts &own = meshParts();
    if ((parts & Measures) && showsStretch())
        mContext.shownMap.stretch();
    if ((parts & Vertices) && mAsMap) // drawn without places and light
        mVertices.assign(static_cast<std::size_t>(own.mesh->soupCornerCount()), {});
    if (parts & Uvs) {
        mUvs = soupUvs(uv());
        mUvBox = layoutBox(uv());
    }
    if (parts & Ghost)
        rebuildGhost();
    if (parts & Faces)
        rebuildFaces();
    if (parts & Sides) {
        const std::vector<std::uint8_t> &straight = document->seams().straight;
        mShowsStraight =
            mOptions.steering && std::find(straight.begin(), straight.end(), 1) != straight.end();
        mSides = sideTexels({*own.mesh, topology(), mContext.shownMap.uv(), mContext.shownMap.separation(),
                             document->seams(), mOptions, shownSelection().edges, document->givenSeams()});
    }
    if (parts & Points)
        rebuildPoints();
}

void SceneContent::rebuildGhost()
{
    mGhostUvs.clear();
    const ShownMap &shown = mContext.shownMap;
    if (mAsMap && shown.ghost().rows() > 0)
        mGhostUvs = soupUvs(shown.ghost());
    else if (mAsMap && shown.isSoup())
        mGhostUvs = soupUvs(ghostUv(*meshParts().mesh, shown.uv(), shown.separation()));
}

void SceneContent::rebuildFaces()
{
    const Document &document = *mContext.workspace.document();
    const MeshParts &own = meshParts();
    static const TriangleStretch none;
    const TriangleStretch &stretch = showsStretch() ? mContext.shownMap.stretch() : none;
    const std::vector<float> density = measureDensity();
    // The solver never flips a triangle, and islands of a live map are only computed when their colours are
    // shown.
    const bool live = mContext.shownMap.isLive();
    std::vector<int> islands(own.mesh->faceCount(), -1);
    if (live && mOptions.coloring == Coloring::Islands)
        islands = liveIslands(*own.mesh, mContext.shownMap.separation());
    for (int face = 0; face < own.mesh->faceCount() && !live; ++face)
        islands[face] = document.islands().islandOfFace(face);
    mTriangleIslands.resize(own.mesh->triangleCount());
    for (int t = 0; t < own.mesh->triangleCount(); ++t)
        mTriangleIslands[t] = static_cast<quint32>(islands[own.mesh->triangleFace[t]] + 1);
    std::vector<bool> flipped(own.mesh->triangleCount(), false);
    if (mOptions.problems && !live)
        flipped = flippedTriangles(*own.mesh, mContext.shownMap.uv(), islands);
    std::span<const int> overlapping;
    if (!live && mContext.map.figures() && mContext.map.figuresAreFresh())
        overlapping = mContext.map.figures()->overlapping;
    const std::shared_ptr<const CornerColors> &colors = document.state().scene.cornerColors;
    mFaces =
        faceTexels({*own.mesh, mContext.shownMap.uv(), mOptions, mColors,
                    mContext.preferences.values().colorBlindHeatMap, mAsMap ? mColors.mapFill : mColors.model,
                    stretch, islands, document.seams().weights, shownSelection().faces, overlapping, flipped,
                    density, mRightDensity, document.state().texelWeights, document.state().hiddenFaces,
                    colors ? std::span<const CornerColor>(*colors) : std::span<const CornerColor>()});
    if (mAsMap && !live && mOptions.fillIslands)
        markBuried(mContext.shownMap.uv(), mFaces);
}

//! Empty when densities are not shown.
std::vector<float> SceneContent::measureDensity()
{
    mRightDensity = std::numeric_limits<double>::quiet_NaN();
    if (mOptions.coloring != Coloring::Density)
        return {};
    const MeshData &own = *mContext.workspace.document()->weightedMesh();
    std::vector<float> density = texelDensities(own, mContext.shownMap.uv(),
                                                mContext.workspace.document()->packingSettings().textureSize);
    mRightDensity = mOptions.densityTarget > 0 ? mOptions.densityTarget : medianDensity(own, density);
    return density;
}

//! Empty when the selection is not to be shown.
const Selection &SceneContent::shownSelection() const
{
    static const Selection none;
    return mOptions.selection ? mContext.workspace.document()->selection() : none;
}

void SceneContent::rebuildPoints()
{
    const Document &document = *mContext.workspace.document();
    mPoints.clear();
    std::vector<QRgb> cornerColor(document.mesh().cornerCount(), 0);
    for (int corner : shownSelection().corners)
        cornerColor[corner] = mColors.selection.rgb();
    if (mOptions.steering) {
        for (const UvPin &pin : document.constraints().pins)
            cornerColor[pin.corner] = (pin.hard ? mColors.hardPin : mColors.softPin).rgb();
    }
    const MeshFrame &ownFrame = frame();
    for (int s = 0; s < document.mesh().soupCornerCount(); ++s) {
        const int corner = document.mesh().cornerOfSoup(s);
        if (cornerColor[corner] == 0 || isHidden(s))
            continue;
        const Vec3 place = mAsMap ? Vec3(uv()(s, 0), uv()(s, 1), 0)
                                  : ownFrame.toFrame(document.mesh().cornerPosition(corner));
        if (place.allFinite())
            mPoints.push_back({{static_cast<float>(place.x()), static_cast<float>(place.y()),
                                static_cast<float>(place.z())},
                               cornerColor[corner]});
    }
}

} // namespace autocuts
