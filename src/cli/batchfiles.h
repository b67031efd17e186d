// Reads and writes the files of a command: meshes and sessions.
#pragma once

#include "cli/clioptions.h"
#include "commands/journalrecorder.h"
#include "model/document/constraints.h"
#include "model/document/islands.h"
#include "model/document/scene.h"

#include <atomic>
#include <memory>

namespace autocuts {

//! Reads the input of a command and writes its output. A session keeps its steering when it is read; when it
//! is written, the new UVs are added to it as one more command. A session written from a mesh file starts
//! with that mesh.
class BatchFiles
{
public:
    //! Reads a mesh file, or the model of a session; the UV set of the options is the first one, that is the
    //! active one. The notes include what the user should know about the session.
    //! \param stop as in readMesh()
    Result<Scene> read(const CliOptions &options, const std::atomic<bool> *stop = nullptr);
    //! Takes a document instead of reading a file. \param journal leads to the document's current state
    Scene take(std::unique_ptr<Document> document, Journal journal);

    //! Replaces options that were not given by the settings of the session, and stores those that were given
    //! in the session. Does nothing without a session.
    void mergeSettings(CliOptions &options);

    //! The input of the solver, with the steering of the session if there is one. \pre read() returned the
    //! scene \param tileHeight as above
    Result<Snapshot> snapshot(const Scene &scene, const SolveSettings &settings, double tileHeight) const;

    //! The flags of the session's islands, per face; empty without a session.
    std::vector<IslandFlags> islandFlags() const;
    //! Sets the flags that the islands have from now on. \param flags per face; empty: they stay
    void setIslandFlags(std::vector<IslandFlags> flags) { mNewFlags = std::move(flags); }

    //! The UV sets of the input, in the order of the file.
    const std::vector<UvSet> &uvSets() const;
    //! What read() has returned, with the pictures that the user of the session chose.
    DocumentState modelOf(const Scene &scene) const;
    //! Those of the session, or of the options without one.
    PackingSettings packingSettings(const CliOptions &options) const
    {
        return mDocument ? mDocument->packingSettings() : options.unwrap.packing;
    }
    int activeUvSet() const { return mDocument ? mDocument->activeUvSet() : mActiveSet; }

    //! The session's rectangle of this name; null when there is none.
    const LayoutRectangle *rectangle(const QString &name) const;

    //! Writes the scene, of which only the first UV set has changed since read().
    //! \param options gives the settings of a new session
    Result<Done> write(const Scene &scene, const CliOptions &options);
    //! What was lost when the session was read, and what could not be written; one line each.
    const QStringList &warnings() const { return mWarnings; }

    //! Lists the data that the format of the output loses, one line each.
    static QStringList losses(const Scene &scene, const QString &path);

private:
    Result<Done> readFile(const CliOptions &options, const std::atomic<bool> *stop);
    void makeUnique();
    Result<Done> chooseUvSet(const CliOptions &options);
    Scene activeFirst() const;
    Result<Done> writeSession(const Scene &scene, const CliOptions &options);

    Scene mOriginal;                    //!< the scene of a mesh file as it was read, with the new UV set
    int mActiveSet = 0;                 //!< of mOriginal
    std::vector<IslandFlags> mNewFlags; //!< per face; empty: those of the document
    QStringList mNotes;                 //!< about the session
    QStringList mWarnings;
    std::unique_ptr<Document> mDocument; //!< null unless a session was read
    std::unique_ptr<JournalRecorder> mRecorder;
};

} // namespace autocuts
