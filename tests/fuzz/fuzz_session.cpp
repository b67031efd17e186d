// Fuzzes the reader of sessions and the replay of their journals. The first byte of the input chooses: a
// whole file, or the content of one block of a good session, with a right checksum, so that the readers
// behind the container are reached. A session that is read must be valid and, written and read again, the
// same.
#include "commands/replay.h"
#include "fuzz/fuzzing.h"
#include "model/io/projects/projectfile.h"

#include <cstdint>

using namespace autocuts;
using fuzz::require;

namespace {

QByteArray bytesOf(const char *name)
{
    QFile file(QStringLiteral(AUTOCUTS_SOURCE_DIR "/tests/data/") + QLatin1String(name));
    require(file.open(QIODevice::ReadOnly), "a session of tests/data cannot be read");
    return file.readAll();
}

const ProjectParts &goodSession()
{
    static const ProjectParts parts =
        readContainer(bytesOf("session-v2.acproj"), 2, QStringLiteral("good")).value();
    return parts;
}

//! The good session with another content of one of its blocks.
QByteArray withBlock(int changed, const QByteArray &content)
{
    std::vector<PackedBlock> blocks;
    int number = 0;
    for (const auto &[name, bytes] : goodSession().parts)
        blocks.push_back(packBlock(name, number++ == changed ? content : bytes, false));
    return containerBytes(goodSession().version, blocks);
}

} // namespace

extern "C" int LLVMFuzzerInitialize(int *, char ***)
{
    char number = 0;
    for (const auto &[name, bytes] : goodSession().parts) {
        fuzz::writeSeed(QString::fromUtf8(name), QByteArray(1, number) + bytes);
        ++number;
    }
    for (const char *name : {"session-v1.acproj", "session-v2.acproj", "journal-v1.acproj"})
        fuzz::writeSeed(QString::fromUtf8(name), QByteArray(1, number) + bytesOf(name));
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    if (size == 0)
        return 0;
    const QByteArray rest(reinterpret_cast<const char *>(data + 1), static_cast<qsizetype>(size) - 1);
    const int count = static_cast<int>(goodSession().parts.size());
    const int choice = data[0] % (count + 1);
    const Result<LoadedProject> read =
        parseProject(choice == count ? rest : withBlock(choice, rest), QStringLiteral("fuzz.acproj"));
    if (!read)
        return 0;
    require(read->state.validate().isEmpty(), "the state is not valid");
    if (read->extras.journal)
        (void)replay(*read->extras.journal);
    const QByteArray written = ProjectWriter().bytes(read->state, read->extras);
    const Result<LoadedProject> again = parseProject(written, QStringLiteral("again.acproj"));
    require(again.ok(), "the written session cannot be read");
    require(again->lost.isEmpty(), "the written session has lost something");
    require(ProjectWriter().bytes(again->state, again->extras) == written, "written twice, the bytes differ");
    return 0;
}
