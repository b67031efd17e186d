// Takes over the models of other programs.
#pragma once

#include "link/handedmodel.h"
#include "model/document/document.h"
#include "views/control/session/studiocontext.h"
#include "views/link/linkclient.h"

#include <QElapsedTimer>
#include <QPointer>
#include <QTimer>

#include <deque>
#include <functional>

namespace autocuts {

//! Makes meshes of "mesh" messages on other threads and puts them into the document, one after the other: as
//! an undoable re-link where the document has another state of the same model, else in its place, where the
//! program says that the user wants that. A running solve is paused for it and goes on afterwards.
class LinkTaking final : public QObject
{
    Q_OBJECT

public:
    //! \param mayLeave asks the user about unsaved work before another model is opened; false: it stays
    LinkTaking(const StudioContext &context, std::function<bool()> mayLeave, QObject *parent = nullptr);

    //! Takes the model of a "mesh" message. The client gets its answer, and its next message is read, when it
    //! was taken or not.
    void take(LinkClient *client, const link::Message &message);

Q_SIGNALS:
    //! What a program has is to be compared with the document.
    void taken(autocuts::LinkClient *client);

private:
    //! A model that waits for the document.
    struct Handed
    {
        QPointer<LinkClient> client;
        link::HandedModel model;
        std::shared_ptr<const MeshData>
            equal; //!< the mesh of the document at that time, where it is the same
        int tries = 0;
    };
    enum class How { Opened, Relinked, Unchanged };

    void add(const QPointer<LinkClient> &client, Result<Handed> handed);
    void proceed();
    bool mustPause(const Handed &handed) const;
    void takeFirst();
    void takeUnchanged();
    void relink();
    void relinked(const Result<QStringList> &lost, const StateToken &before);
    void open();
    void share(How how);
    void answer(How how, const QStringList &lost);
    void refuse(const Error &error);
    void endFirst();

    StudioContext mContext;
    std::function<bool()> mMayLeave;
    std::deque<Handed> mHanded; //!< the first one is being taken
    QTimer mSoon;
    bool mTaking = false;             //!< a job runs for the first one
    bool mAsking = false;             //!< the user is asked about it
    bool mRunAgain = false;           //!< a solve was paused for it
    QPointer<const Document> mPaused; //!< whose solve that was
    QPointer<const Document> mEdited; //!< was re-linked last
    QElapsedTimer mSinceEdit;         //!< since then
    quint64 mGesture = 0;             //!< of that edit
};

} // namespace autocuts
