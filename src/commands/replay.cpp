#include "commands/replay.h"

#include "commands/commandfactory.h"
#include "commands/edittextures.h"
#include "model/io/files/deflate.h"

#include <QtEndian>

#include <algorithm>
#include <span>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

constexpr qsizetype sizeBytes = sizeof(quint32);

std::optional<QCborMap> commandOf(const QByteArray &entry)
{
    if (entry.size() < sizeBytes)
        return std::nullopt;
    const auto size = qFromLittleEndian<quint32>(entry.constData());
    const std::optional<QByteArray> bytes = inflated(QByteArrayView(entry).sliced(sizeBytes), size);
    if (!bytes)
        return std::nullopt;
    QCborParserError error;
    const QCborValue value = QCborValue::fromCbor(*bytes, &error);
    if (error.error != QCborError::NoError || !value.isMap())
        return std::nullopt;
    return value.toMap();
}

Error atCommand(std::size_t index, Error error)
{
    error.message = u"command %1 of the journal: %2"_s.arg(index + 1).arg(error.message);
    return error;
}

} // namespace

QByteArray compressedEntry(const QByteArray &command)
{
    QByteArray entry(sizeBytes, Qt::Uninitialized);
    qToLittleEndian(static_cast<quint32>(command.size()), entry.data());
    return entry + deflated(command);
}

QByteArray journalEntry(const QCborMap &command)
{
    return compressedEntry(command.toCborValue().toCbor());
}

Result<std::unique_ptr<Document>>
replay(const Journal &journal,
       const std::function<void(const Document &, const DocumentCommand &next)> &before)
{
    auto document = std::make_unique<Document>(journal.initial);
    // A replayed history is never undone, so it needs no memory.
    document->undoStack().setMemoryLimit(0);
    for (std::size_t i = 0; i < journal.commands.size(); ++i) {
        const std::optional<QCborMap> map = commandOf(journal.commands[i]);
        if (!map)
            return atCommand(i, damagedCommand());
        Result<std::unique_ptr<DocumentCommand>> command = makeCommand(*map, *document);
        if (!command)
            return atCommand(i, command.error());
        if (before)
            before(*document, *command.value());
        pushCommand(std::move(command).value());
    }
    return document;
}

namespace {

//! The document with its last commands on the undo stack; null where they do not lead to the state.
std::unique_ptr<Document> withHistory(const DocumentState &state, const Journal &past,
                                      std::span<const QByteArray> commands, const std::atomic<bool> *stop)
{
    const Result<std::unique_ptr<Document>> begin = replay(past);
    if (!begin)
        return nullptr;
    auto document = std::make_unique<Document>(begin.value()->state());
    for (const QByteArray &entry : commands) {
        const std::optional<QCborMap> map = commandOf(entry);
        Result<std::unique_ptr<DocumentCommand>> command =
            map ? makeCommand(*map, *document) : damagedCommand();
        if (!command || (stop && stop->load()))
            return nullptr;
        pushCommand(std::move(command).value());
    }
    if (document->undoStack().releasedCount() > 0 || !sameWork(document->state(), state))
        return nullptr;
    document->setSelection(state.selection);
    document->setViewState(state.viewState);
    document->undoStack().setClean();
    return document;
}

} // namespace

RestoredSession restoredSession(DocumentState state, std::optional<Journal> journal, QThread *thread,
                                const std::atomic<bool> *stop, int most)
{
    RestoredSession session;
    const auto kept = journal ? std::min<std::ptrdiff_t>(std::ssize(journal->commands), most) : 0;
    if (kept > 0) {
        const auto last = journal->commands.end() - kept;
        Journal past{journal->initial, {journal->commands.begin(), last}};
        session.document = withHistory(state, past, {last, journal->commands.end()}, stop);
        if (session.document)
            session.past = std::move(past);
    }
    if (!session.document)
        session = {std::make_unique<Document>(std::move(state)), std::move(journal)};
    session.document->undoStack().moveToThread(thread);
    session.document->moveToThread(thread);
    return session;
}

std::optional<UvMatrix> mapOfTextures(const Journal &journal)
{
    const DocumentState &initial = journal.initial;
    if (initial.activeUvSet >= std::ssize(initial.scene.uvSets))
        return std::nullopt;
    UvMatrix map = initial.scene.uvSets[std::size_t(initial.activeUvSet)].uv;
    const auto replayed = replay(journal, [&map](const Document &document, const DocumentCommand &next) {
        if (next.commandId() == CommandId::EditTextures && static_cast<const EditTextures &>(next).fitsMap())
            map = document.uv();
    });
    if (!replayed || !map.array().isFinite().any())
        return std::nullopt;
    return map;
}

bool sameWork(const DocumentState &a, const DocumentState &b)
{
    const auto work = [](DocumentState state) {
        state.selection = {};
        state.viewState.clear();
        return state;
    };
    return work(a) == work(b);
}

} // namespace autocuts
