#include "views/control/pictures/modelpictures.h"

#include "model/pictures/picturereading.h"
#include "model/pictures/texturefiles.h"
#include "views/control/session/workspace.h"
#include "views/gl/texturelayers.h"

#include <QDir>
#include <QFileInfo>
#include <QPointer>

#include <algorithm>
#include <map>

namespace autocuts {

namespace {

//! More are only counted in a message.
constexpr qsizetype mostListed = 3;
//! Files and folders that are watched; more are not. Chosen by hand.
constexpr qsizetype mostWatched = 1000;
//! After the last change of a file, before it is read. Chosen by hand.
constexpr int settleMs = 250;

QString shownName(const SceneTexture &texture)
{
    const QString name = QFileInfo(QString(texture.file).replace(u'\\', u'/')).fileName();
    return name.isEmpty() ? ModelPictures::tr("a picture inside of the model's file") : name;
}

} // namespace

//! What is to be read, each set once. Names are in place of paths.
struct ModelPictures::Wanted
{
    std::vector<TextureSetRequest> sets;
    std::vector<std::map<TextureChannel, bool>>
        chosen; //!< of each set: the channels, and whether of the user
    std::vector<int> setOfMaterial;
    bool onlyColors = false;

    static Wanted by(const DocumentState &state, bool onlyColors);
    void resolve(const QString &modelPath);
    QStringList paths() const;
    std::vector<PictureRequest> colors() const;
};

struct ModelPictures::Loaded
{
    Pictures pictures;
    QStringList problems, paths;
    std::vector<FileState> states;
    std::vector<int> setOfMaterial;
    bool haveNormals = false;
};

ModelPictures::Wanted ModelPictures::Wanted::by(const DocumentState &state, bool onlyColors)
{
    Wanted wanted;
    wanted.onlyColors = onlyColors;
    std::vector<TextureSet> known;
    std::vector<QRgb> knownColors;
    std::multimap<QStringList, std::size_t> places; // in known, by the names of the pictures
    const Scene &scene = state.scene;
    for (int material = -1; material < std::ssize(scene.materialNames); ++material) {
        TextureSet set = state.textureSet(material);
        if (onlyColors)
            std::erase_if(set, [](const auto &entry) { return entry.first != TextureChannel::BaseColor; });
        const auto place = static_cast<std::size_t>(material);
        const QRgb color =
            material >= 0 && place < scene.materialColors.size() ? scene.materialColors[place] : 0;
        const bool any = std::any_of(set.begin(), set.end(),
                                     [](const auto &entry) { return !entry.second.picture.isEmpty(); });
        if (!any) {
            wanted.setOfMaterial.push_back(-1);
            continue;
        }
        QStringList names;
        for (const auto &[channel, entry] : set)
            names << entry.picture.file;
        const auto [first, end] = places.equal_range(names);
        const auto same = std::find_if(first, end, [&](const auto &entry) {
            return known[entry.second] == set && (onlyColors || knownColors[entry.second] == color);
        });
        wanted.setOfMaterial.push_back(static_cast<int>(same == end ? known.size() : same->second));
        if (same != end)
            continue;
        places.emplace(names, known.size());
        known.push_back(set);
        knownColors.push_back(color);
        TextureSetRequest &request = wanted.sets.emplace_back();
        auto &chosen = wanted.chosen.emplace_back();
        request.color = color;
        for (const auto &[channel, entry] : set) {
            const SceneTexture &picture = entry.picture;
            request.channels[channel] = {
                {picture.file, picture.content, picture.isEmpty() ? QString() : shownName(picture)}, entry};
            chosen[channel] = isChosenTexture(state, material, channel);
        }
    }
    return wanted;
}

//! Finds the files; on the thread that reads them.
void ModelPictures::Wanted::resolve(const QString &modelPath)
{
    FolderNames folders;
    for (std::size_t s = 0; s < sets.size(); ++s) {
        for (auto &[channel, wanted] : sets[s].channels)
            wanted.picture.path =
                wanted.picture.content.isEmpty()
                    ? texturePath(wanted.picture.path, chosen[s].at(channel), modelPath, &folders)
                    : QString();
    }
}

QStringList ModelPictures::Wanted::paths() const
{
    QStringList result;
    for (const TextureSetRequest &set : sets) {
        for (const auto &[channel, wanted] : set.channels) {
            if (!wanted.picture.path.isEmpty())
                result << wanted.picture.path;
        }
    }
    result.removeDuplicates();
    return result;
}

std::vector<PictureRequest> ModelPictures::Wanted::colors() const
{
    std::vector<PictureRequest> result;
    for (const TextureSetRequest &set : sets)
        result.push_back(set.channels.at(TextureChannel::BaseColor).picture);
    return result;
}

ModelPictures::ModelPictures(const Workspace &workspace, const ViewState &view, QObject *parent)
    : QObject(parent), mWorkspace(workspace), mView(view), mLight(view)
{
    connect(&workspace, &Workspace::documentReplaced, this, [this] {
        forget();
        loadIfShown();
    });
    connect(&workspace, &Workspace::changed, this, [this](const ChangeEvent &event) {
        if (event.type != ChangeEvent::Type::Textures)
            return;
        mStale = true;
        loadIfShown();
        Q_EMIT changed();
    });
    connect(&view, &ViewState::optionsChanged, this, &ModelPictures::loadIfShown);
    connect(&mLight, &SceneLight::changed, this, &ModelPictures::changed);
    connect(&mLight, &SceneLight::noticed, this, &ModelPictures::noticed);
    mLookTimer.setSingleShot(true);
    mLookTimer.setInterval(settleMs);
    connect(&mLookTimer, &QTimer::timeout, this, &ModelPictures::lookForChanges);
    const auto lookSoon = [this] { mLookTimer.start(); };
    connect(&mWatcher, &QFileSystemWatcher::fileChanged, this, lookSoon);
    connect(&mWatcher, &QFileSystemWatcher::directoryChanged, this, lookSoon);
}

int ModelPictures::count() const
{
    const Document *document = mWorkspace.document();
    int result = 0;
    for (int m = -1; document && m < std::ssize(document->state().scene.materialNames); ++m) {
        const TextureSet set = document->state().textureSet(m);
        result += std::any_of(set.begin(), set.end(),
                              [](const auto &entry) { return !entry.second.picture.isEmpty(); });
    }
    return result;
}

bool ModelPictures::hasSets() const
{
    const Document *document = mWorkspace.document();
    for (int m = -1; document && m < std::ssize(document->state().scene.materialNames); ++m) {
        for (const auto &[channel, entry] : document->state().textureSet(m)) {
            if (channel != TextureChannel::BaseColor && !entry.picture.isEmpty())
                return true;
        }
    }
    return false;
}

void ModelPictures::forget()
{
    mLoading.drop();
    mMesh.reset();
    mPictures = {};
    mSetOfMaterial.clear();
    mCommonSet = -1;
    mHaveNormals = false;
    mProblems.clear();
    mPaths.clear();
    watch({});
    Q_EMIT changed();
    Q_EMIT loadingChanged();
}

void ModelPictures::loadIfShown()
{
    const Document *document = mWorkspace.document();
    const Pattern pattern = mView.options().pattern;
    if (!document || (pattern != Pattern::Materials && pattern != Pattern::Physical))
        return;
    const Scene &scene = document->state().scene;
    if (mMesh == scene.mesh && mPattern == pattern && !mStale)
        return;
    if (mPattern != pattern)
        mPictures = {}; // of another kind
    mMesh = scene.mesh;
    mPattern = pattern;
    mStale = false;
    mLoading.start(
        [wanted = Wanted::by(document->state(), pattern == Pattern::Materials),
         path = scene.path](const std::atomic<bool> &stop) mutable {
            Loaded loaded;
            loaded.setOfMaterial = wanted.setOfMaterial;
            wanted.resolve(path);
            loaded.paths = wanted.paths();
            loaded.states = statesOf(loaded.paths); // before they are read: a later change is seen then
            loaded.pictures =
                readyForUpload(wanted.onlyColors ? readPictures(wanted.colors(), loaded.problems, &stop)
                                                 : readTextureSets(wanted.sets, loaded.problems, &stop),
                               &stop);
            for (const TextureSetRequest &set : wanted.sets)
                loaded.haveNormals = loaded.haveNormals || set.channels.contains(TextureChannel::Normal) ||
                                     set.channels.contains(TextureChannel::Height);
            return loaded;
        },
        [this](const Loaded &loaded) { takeOver(loaded); },
        [this](const QString &message) {
            Loaded nothing;
            nothing.problems << message;
            takeOver(nothing);
        });
    Q_EMIT loadingChanged();
}

void ModelPictures::takeOver(const Loaded &loaded)
{
    mPictures = loaded.pictures;
    mSetOfMaterial = loaded.setOfMaterial;
    mHaveNormals = loaded.haveNormals;
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
    mPaths = loaded.paths;
    mStates = loaded.states;
    watch(mPaths);
    Q_EMIT changed();
    Q_EMIT loadingChanged();
    tellProblems(loaded.problems);
    mLookTimer.start(); // for what changed before it was watched
}

void ModelPictures::tellProblems(const QStringList &problems)
{
    if (problems == mProblems)
        return;
    mProblems = problems;
    if (problems.isEmpty())
        return;
    QStringList listed = problems.mid(0, mostListed);
    if (const qsizetype more = problems.size() - listed.size(); more > 0)
        listed << tr("and %1 more").arg(more);
    Q_EMIT noticed(tr("Textures that cannot be shown: %1").arg(listed.join(QStringLiteral(", "))));
}

//! Also the folders are watched: many programs delete a file, or move it away, before they write the new one.
void ModelPictures::watch(const QStringList &paths)
{
    if (const QStringList old = mWatcher.files() + mWatcher.directories(); !old.isEmpty())
        mWatcher.removePaths(old);
    QStringList watched;
    FolderNames folders;
    for (const QString &path : paths) {
        if (const QString folder = QFileInfo(path).absolutePath(); QFileInfo(folder).isDir())
            watched << folder;
        for (const TextureTile &tile : textureTiles(path, &folders))
            watched << tile.path;
    }
    watched.removeDuplicates();
    if (watched = watched.mid(0, mostWatched); !watched.isEmpty())
        mWatcher.addPaths(watched);
}

std::vector<ModelPictures::FileState> ModelPictures::statesOf(const QStringList &paths)
{
    std::vector<FileState> states;
    FolderNames folders;
    for (const QString &path : paths) {
        for (const TextureTile &tile : textureTiles(path, &folders)) {
            const QFileInfo info(tile.path);
            states.push_back({tile.path, info.lastModified(), info.size()});
        }
    }
    return states;
}

void ModelPictures::lookForChanges()
{
    if (isLoading() || mPaths.isEmpty())
        return;
    watch(mPaths); // a file that was replaced is no longer watched
    if (statesOf(mPaths) == mStates)
        return;
    mStale = true;
    loadIfShown();
}

int ModelPictures::setOfMaterial(int material) const
{
    const auto place = static_cast<std::size_t>(material + 1);
    return material >= -1 && place < mSetOfMaterial.size() ? mSetOfMaterial[place] : -1;
}

int ModelPictures::setOfFace(int face) const
{
    const Document *document = mWorkspace.document();
    if (!document || document->state().scene.mesh != mMesh)
        return -1;
    const std::vector<int> &materials = document->state().scene.faceMaterial;
    const auto place = static_cast<std::size_t>(face);
    return setOfMaterial(place < materials.size() ? materials[place] : -1);
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

QImage ModelPictures::thumbnail(int material, TextureChannel channel, int side) const
{
    const int number = setOfMaterial(material);
    if (number < 0 || number >= std::ssize(mPictures.sets))
        return {};
    const Pictures::Set &set = mPictures.sets[static_cast<std::size_t>(number)];
    const int first = set.repeated >= 0 ? set.repeated : set.tiles.empty() ? -1 : set.tiles.begin()->second;
    return first < 0 ? QImage() : channelImage(mPictures, first, channel, side);
}

} // namespace autocuts
