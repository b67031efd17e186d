#include "views/control/modelpictures.h"

#include "model/io/texturefiles.h"
#include "views/control/workspace.h"
#include "views/gl/picturereading.h"
#include "views/state/viewstate.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>
#include <QThreadPool>

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

//! More are only counted in a message.
constexpr qsizetype mostListed = 3;

//! What is to be read for the materials, each picture once.
struct Wanted
{
    std::vector<PictureRequest> requests; //!< names in place of paths
    std::vector<int> setOfMaterial;
};

Wanted wantedBy(const Scene &scene)
{
    Wanted wanted;
    std::map<std::pair<QString, const char *>, int> known;
    for (const SceneTexture &texture : scene.materialTextures) {
        if (texture.isEmpty()) {
            wanted.setOfMaterial.push_back(-1);
            continue;
        }
        const char *bytes = texture.content.isEmpty() ? nullptr : texture.content.constData();
        const auto [found, isNew] =
            known.try_emplace({texture.file, bytes}, static_cast<int>(wanted.requests.size()));
        wanted.setOfMaterial.push_back(found->second);
        if (!isNew)
            continue;
        const QString name = QFileInfo(QString(texture.file).replace(u'\\', u'/')).fileName();
        wanted.requests.push_back(
            {texture.file, texture.content,
             name.isEmpty() ? ModelPictures::tr("a picture inside of the model's file") : name});
    }
    return wanted;
}

} // namespace

ModelPictures::ModelPictures(const Workspace &workspace, const ViewState &view, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mView(view)
{
    connect(&workspace, &Workspace::documentReplaced, this, [this] {
        forget();
        loadIfShown();
    });
    connect(&view, &ViewState::optionsChanged, this, &ModelPictures::loadIfShown);
}

ModelPictures::~ModelPictures()
{
    if (mLoading)
        *mLoading = true;
}

int ModelPictures::count() const
{
    const Document *document = mWorkspace.document();
    if (!document)
        return 0;
    const std::vector<SceneTexture> &textures = document->state().scene.materialTextures;
    return static_cast<int>(std::count_if(textures.begin(), textures.end(),
                                          [](const SceneTexture &texture) { return !texture.isEmpty(); }));
}

void ModelPictures::forget()
{
    if (mLoading)
        *mLoading = true;
    mLoading.reset();
    mMesh.reset();
    mPictures = {};
    mSetOfMaterial.clear();
    mCommonSet = -1;
    Q_EMIT changed();
}

void ModelPictures::loadIfShown()
{
    const Document *document = mWorkspace.document();
    if (!document || mView.options().pattern != Pattern::Materials || mMesh || count() == 0)
        return;
    const Scene &scene = document->state().scene;
    mMesh = scene.mesh;
    Wanted wanted = wantedBy(scene);
    mSetOfMaterial = std::move(wanted.setOfMaterial);
    mLoading = std::make_shared<std::atomic<bool>>(false);
    // The result is passed to the GUI thread, and ignored there when another model was opened meanwhile.
    QThreadPool::globalInstance()->start([requests = std::move(wanted.requests), path = scene.path,
                                          stop = mLoading, self = QPointer<ModelPictures>(this)]() mutable {
        for (PictureRequest &request : requests)
            request.path = findTexture(request.path, path);
        QStringList problems;
        const Pictures pictures = readPictures(requests, problems, stop.get());
        QMetaObject::invokeMethod(
            QCoreApplication::instance(),
            [self, stop, pictures, problems] {
                if (self && self->mLoading == stop)
                    self->takeOver(pictures, problems);
            },
            Qt::QueuedConnection);
    });
}

void ModelPictures::takeOver(const Pictures &pictures, const QStringList &problems)
{
    mLoading.reset();
    mPictures = pictures;
    for (int &set : mSetOfMaterial) {
        if (set >= 0 && mPictures.sets[static_cast<std::size_t>(set)].isEmpty())
            set = -1;
    }
    std::map<int, int> faces; // with each set
    for (int face = 0; face < mMesh->faceCount(); ++face)
        ++faces[setOfFace(face)];
    faces.erase(-1);
    const auto most = std::max_element(faces.begin(), faces.end(),
                                       [](const auto &a, const auto &b) { return a.second < b.second; });
    mCommonSet = most == faces.end() ? -1 : most->first;
    Q_EMIT changed();
    if (problems.isEmpty())
        return;
    QStringList listed = problems.mid(0, mostListed);
    if (const qsizetype more = problems.size() - listed.size(); more > 0)
        listed << tr("and %1 more").arg(more);
    Q_EMIT noticed(tr("Textures that cannot be shown: %1").arg(listed.join(QStringLiteral(", "))));
}

int ModelPictures::setOfFace(int face) const
{
    const Document *document = mWorkspace.document();
    if (!document || document->state().scene.mesh != mMesh)
        return -1;
    const std::vector<int> &materials = document->state().scene.faceMaterial;
    const auto place = static_cast<std::size_t>(face);
    const int material = place < materials.size() ? materials[place] : -1;
    return material < 0 || material >= std::ssize(mSetOfMaterial)
               ? -1
               : mSetOfMaterial[static_cast<std::size_t>(material)];
}

std::vector<quint32> ModelPictures::triangleSets() const
{
    const Document *document = mWorkspace.document();
    if (!document)
        return {};
    const MeshData &mesh = document->mesh();
    std::vector<quint32> sets(static_cast<std::size_t>(mesh.triangleCount()));
    for (int t = 0; t < mesh.triangleCount(); ++t)
        sets[static_cast<std::size_t>(t)] = static_cast<quint32>(setOfFace(mesh.triangleFace[t]) + 1);
    return sets;
}

int ModelPictures::shownSet() const
{
    const Document *document = mWorkspace.document();
    if (!document || document->selection().faces.isEmpty())
        return mCommonSet;
    return setOfFace(document->selection().faces.first());
}

} // namespace autocuts
