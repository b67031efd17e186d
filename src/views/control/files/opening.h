// Documents of files and models, with what the views need of them.
#pragma once

#include "commands/replay.h"
#include "model/document/document.h"

#include <QStringList>

#include <atomic>
#include <functional>
#include <memory>

class QThread;

namespace autocuts {

struct MeshDrawing;
struct PreferenceValues;

//! A session from a file.
struct LoadedSession
{
    RestoredSession session;
    QStringList notes;                          //!< for the user, one line each
    std::shared_ptr<const MeshDrawing> drawing; //!< null: it is made when it is needed
};

//! A document of a model that was read or made.
struct NewDocument
{
    std::unique_ptr<Document> document;
    QStringList notes;                          //!< for the user, one line each
    std::shared_ptr<const MeshDrawing> drawing; //!< null: it is made when it is needed
};

//! A session from a file, made on the thread of a job. \param thread where it is to be used
Result<LoadedSession> loadSession(const QString &path, QThread *thread, const std::atomic<bool> &stop);
//! A document of a model. \param prepare changes the state that it begins with
Result<NewDocument> newDocument(Scene scene, const PreferenceValues &preferences,
                                const std::function<void(DocumentState &)> &prepare = {});
//! A document of a model's file, made on the thread of a job. \param thread where it is to be used
Result<NewDocument> readModel(const QString &path, const PreferenceValues &preferences, QThread *thread,
                              const std::atomic<bool> &stop);

} // namespace autocuts
