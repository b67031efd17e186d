#include "views/link/linktaking.h"

#include "views/control/files/filecontroller.h"
#include "views/control/jobs/mapcontroller.h"
#include "views/control/live/solvercontroller.h"
#include "views/control/session/workspace.h"
#include "views/link/linkmerging.h"

#include <QGuiApplication>
#include <QJsonArray>

#include <algorithm>
#include <utility>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int mostTries = 20; // of a re-link that edits overtake; chosen by hand
constexpr int patience = 100; // milliseconds until a dialog or a drag is looked for again; chosen by hand
constexpr int oneEdit = 1500; // milliseconds between two states of one edit, such as a drag; chosen by hand

//! True while a dialog may hold the document, or a drag changes it.
bool userIsBusy()
{
    return QGuiApplication::modalWindow() || QGuiApplication::mouseButtons() != Qt::NoButton;
}

//! True when the scene is another state of the document's model.
bool isSameModel(const Document &document, const Scene &scene)
{
    const Scene &own = document.state().scene;
    return own.path == scene.path &&
           std::ranges::find_first_of(own.objectNames, scene.objectNames) != own.objectNames.end();
}

//! True when a handed state of a model has the polygons and objects of the own one, and its materials, if it
//! says anything of them.
bool isEqual(const Scene &own, const Scene &handed)
{
    const bool sameMaterials = handed.materialNames.empty() || (own.materialNames == handed.materialNames &&
                                                                own.faceMaterial == handed.faceMaterial);
    return own.mesh && sameMaterials && own.objectNames == handed.objectNames &&
           samePolygons(*own.mesh, *handed.mesh);
}

} // namespace

LinkTaking::LinkTaking(const StudioContext &context, std::function<bool()> mayLeave, QObject *parent)
    : QObject(parent), mContext(context), mMayLeave(std::move(mayLeave))
{
    mSoon.setSingleShot(true);
    connect(&mSoon, &QTimer::timeout, this, &LinkTaking::proceed);
    const auto soon = [this] { mSoon.start(0); };
    connect(&mContext.solver, &SolverController::stateChanged, this, soon);
    connect(&mContext.files.jobs(), &JobRunner::busyChanged, this, soon);
    connect(&mContext.map.jobs(), &JobRunner::busyChanged, this, soon);
    connect(&mContext.workspace, &Workspace::documentReplaced, this,
            [this] { mRunAgain = mRunAgain && mPaused && mPaused == mContext.workspace.document(); });
}

void LinkTaking::take(LinkClient *client, const link::Message &message)
{
    const Document *document = mContext.workspace.document();
    auto work = [message, own = document ? document->state().scene
                                         : Scene()](const std::atomic<bool> &) -> Result<Handed> {
        Result<link::HandedModel> model = link::readHandedModel(message);
        if (!model)
            return model.error();
        const bool equal = isEqual(own, model->scene);
        return Handed{nullptr, std::move(model).value(), equal ? own.mesh : nullptr};
    };
    auto add = [self = QPointer(this), client](Result<Handed> handed) {
        if (self)
            self->add(client, std::move(handed));
    };
    client->reading.start(std::move(work), std::move(add),
                          [client](const QString &problem) { client->end(link::linkError(problem)); });
}

void LinkTaking::add(const QPointer<LinkClient> &client, Result<Handed> handed)
{
    if (!client)
        return;
    if (!handed) {
        client->end(handed.error());
        return;
    }
    mHanded.push_back(std::move(handed).value());
    mHanded.back().client = client;
    proceed();
}

//! Takes the first model as soon as nothing else changes the document.
void LinkTaking::proceed()
{
    if (mAsking)
        return;
    if (mTaking) {
        // The job was cancelled or failed, where it has not answered.
        if (!mContext.files.jobs().isBusy())
            refuse({u"the model was not taken over"_s, {}, 0, u"Hand it over again"_s});
        return;
    }
    while (!mHanded.empty() && !mHanded.front().client)
        mHanded.pop_front();
    if (mHanded.empty()) {
        if (std::exchange(mRunAgain, false))
            mContext.solver.run();
        return;
    }
    if (mContext.files.jobs().isBusy() || mContext.map.jobs().isBusy())
        return;
    if (userIsBusy()) {
        mSoon.start(patience);
        return;
    }
    SolverController &solver = mContext.solver;
    if (mustPause(mHanded.front()) && (solver.isRunning() || solver.isPausing())) {
        mRunAgain |= solver.isRunning() && !solver.isLimited();
        mPaused = mContext.workspace.document();
        solver.pauseAtOnce();
        return;
    }
    takeFirst();
}

//! A solve is not disturbed by what it has already, nor by what will be refused.
bool LinkTaking::mustPause(const Handed &handed) const
{
    const Document *document = mContext.workspace.document();
    if (!document || !isSameModel(*document, handed.model.scene))
        return handed.model.opens;
    return handed.equal != document->state().scene.mesh || !handed.model.scene.uvSets.empty();
}

void LinkTaking::takeFirst()
{
    const Handed &handed = mHanded.front();
    const Document *document = mContext.workspace.document();
    const bool same = document && isSameModel(*document, handed.model.scene);
    if (same && handed.equal == document->state().scene.mesh)
        takeUnchanged();
    else if (same)
        relink();
    else if (handed.model.opens)
        open();
    else
        refuse(link::otherModel());
}

void LinkTaking::takeUnchanged()
{
    mHanded.front().model.scene.mesh = mHanded.front().equal;
    share(How::Unchanged);
    answer(How::Unchanged, {});
}

void LinkTaking::relink()
{
    mTaking = true;
    ++mHanded.front().tries;
    Document &document = *mContext.workspace.document();
    if (mEdited != &document || !mSinceEdit.isValid() || mSinceEdit.elapsed() > oneEdit)
        mGesture = document.undoStack().newGesture();
    const bool started = mContext.files.relinkHanded(
        mHanded.front().model.scene, mGesture,
        [this, before = document.token()](const Result<QStringList> &lost) { relinked(lost, before); });
    if (!started)
        mTaking = false; // another file was faster: when that is read
}

void LinkTaking::relinked(const Result<QStringList> &lost, const StateToken &before)
{
    const bool overtaken =
        !mContext.workspace.isInState(before) || mContext.solver.isRunning() || mContext.solver.isPausing();
    mTaking = false;
    if (!lost && overtaken && mHanded.front().tries < mostTries) {
        mSoon.start(0);
    } else if (!lost) {
        refuse(lost.error());
    } else {
        mEdited = mContext.workspace.document();
        mSinceEdit.start();
        share(How::Relinked);
        answer(How::Relinked, lost.value());
    }
}

void LinkTaking::open()
{
    mAsking = true;
    const bool may = mMayLeave();
    mAsking = false;
    const link::HandedModel &model = mHanded.front().model;
    if (!mHanded.front().client) {
        mSoon.start(0); // it has gone while the user was asked
        return;
    }
    if (!may) {
        refuse({u"the user keeps the open session"_s, {}, 0, u"Save or close it first"_s});
        return;
    }
    mRunAgain = false; // another model
    mContext.map.jobs().abandon();
    const Result<Done> opened = mContext.files.adopt(
        model.scene, [&](DocumentState &state) { prepareMarks(state, *model.edges, model.marks); });
    if (!opened) {
        refuse(opened.error());
        return;
    }
    share(How::Opened);
    answer(How::Opened, {});
}

//! Notes what the program has, and puts its own into the document.
void LinkTaking::share(How how)
{
    const Handed &handed = mHanded.front();
    const link::HandedModel &model = handed.model;
    if (!handed.client)
        return;
    Document &document = *mContext.workspace.document();
    link::SharedModel &shared = handed.client->shared;
    shared = {model.serial, model.scene.mesh, model.edges, {}, {}, false, {}};
    shared.marks.apply(model.marks);
    if (!model.scene.uvSets.empty())
        shared.uvs = link::toLinkUvs(model.scene.uvSets.front().uv, 1);
    link::NamedTextures textures{model.scene.materialNames, {}};
    for (int material = 0; material < int(textures.names.size()); ++material)
        textures.sets.push_back(model.scene.fileSet(material));
    shared.textures = textures.written();
    ++handed.client->revision;
    if (how == How::Opened)
        return;
    applyMarks(document, *model.edges, model.marks);
    applyTextures(document, textures);
    if (!model.scene.uvSets.empty())
        applyUvs(document, model.scene.uvSets.front().uv);
}

void LinkTaking::answer(How how, const QStringList &lost)
{
    if (LinkClient *client = mHanded.front().client) {
        link::Message taken(u"taken"_s);
        taken.set(u"serial"_s, mHanded.front().model.serial);
        taken.set(u"how"_s, how == How::Opened     ? u"opened"_s
                            : how == How::Relinked ? u"relinked"_s
                                                   : u"unchanged"_s);
        taken.set(u"lost"_s, QJsonArray::fromStringList(lost));
        client->send(taken);
        client->flush(); // before the views are drawn
        client->wasLeft = false;
        Q_EMIT this->taken(client);
    }
    endFirst();
}

void LinkTaking::refuse(const Error &error)
{
    mTaking = false;
    if (LinkClient *client = mHanded.front().client)
        client->refuse(mHanded.front().model.serial, error);
    endFirst();
}

void LinkTaking::endFirst()
{
    if (LinkClient *client = mHanded.front().client)
        client->next();
    mHanded.pop_front();
    mSoon.start(0);
}

} // namespace autocuts
