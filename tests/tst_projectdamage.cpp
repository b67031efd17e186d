// 2,000 damaged project files: an error or whatever is whole, never a crash, and no more memory than twice
// that of the file as it was.
#include "commands/replay.h"
#include "support/randomedits.h"
#include "support/sessions.h"

#include "model/io/projects/projectmigration.h"
#include "model/io/projects/projectstate.h"

#include <QFile>
#include <QTest>

#include <functional>
#include <tuple>

#ifdef Q_OS_LINUX
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace tst_projectdamage {

using namespace autocuts;
using namespace Qt::Literals::StringLiterals;

namespace {

constexpr int filesOfEachKind = 1000;

//! Keeps the program's memory to what it has plus some bytes, as far as the system can do that. The address
//! sanitizer takes address space for itself: there, ASAN_OPTIONS refuse large requests (CMakeLists.txt).
class MemoryLimit
{
public:
    explicit MemoryLimit([[maybe_unused]] qint64 bytes)
    {
#if defined(Q_OS_LINUX) && !defined(AUTOCUTS_SANITIZED)
        getrlimit(RLIMIT_AS, &mBefore);
        rlimit limit = mBefore;
        limit.rlim_cur = static_cast<rlim_t>(inUse() + bytes);
        mSet = setrlimit(RLIMIT_AS, &limit) == 0;
#endif
    }
    ~MemoryLimit()
    {
#ifdef Q_OS_LINUX
        if (mSet)
            setrlimit(RLIMIT_AS, &mBefore);
#endif
    }
    MemoryLimit(const MemoryLimit &) = delete;
    MemoryLimit &operator=(const MemoryLimit &) = delete;

    //! Address space that the program has now.
    static qint64 inUse()
    {
        QFile file(u"/proc/self/statm"_s);
        if (!file.open(QIODevice::ReadOnly))
            return 0;
        return file.readAll().split(' ').first().toLongLong() * 4096;
    }

private:
#ifdef Q_OS_LINUX
    rlimit mBefore = {};
    bool mSet = false;
#endif
};

//! Overwrites, cuts out, inserts and exchanges bytes.
void damage(QByteArray &bytes, test::Random &random)
{
    const auto place = [&] { return random.below(static_cast<int>(bytes.size())); };
    const auto length = [&](int at) {
        return 1 + random.below(std::min(64, static_cast<int>(bytes.size()) - at));
    };
    if (bytes.isEmpty())
        return;
    const int at = place();
    switch (random.below(7)) {
    case 0: // flipped bits
        for (int i = 0; i <= random.below(4); ++i) {
            const int byte = place();
            bytes[byte] = static_cast<char>(bytes[byte] ^ 1 << random.below(8));
        }
        break;
    case 1: // cut off
        bytes.truncate(at);
        break;
    case 2: // cut out
        bytes.remove(at, length(at));
        break;
    case 3: // a huge length
        bytes.replace(at, 9,
                      QByteArray(1, "\x5b\x7b\x9b\xbb"[random.below(4)]) +
                          QByteArray(1 + random.below(2), '\0') + QByteArray(7, '\xff'));
        break;
    case 4: // two pieces exchanged
    {
        const int other = place();
        const int size = std::min(length(at), length(other));
        const QByteArray piece = bytes.mid(at, size);
        bytes.replace(at, size, bytes.mid(other, size));
        bytes.replace(other, size, piece);
        break;
    }
    case 5: // noise
        for (int i = at, end = at + length(at); i < end; ++i)
            bytes[i] = static_cast<char>(random.below(256));
        break;
    default: // twice
        bytes.insert(at, bytes.mid(at, length(at)));
    }
}

//! What must hold of a file that opens, however it was damaged.
void checkOpened(const LoadedProject &project)
{
    QCOMPARE(project.state.validate(), QString());
    const QByteArray again = ProjectWriter().bytes(project.state, project.extras);
    const Result<LoadedProject> reopened = parseProject(again, {});
    QVERIFY(reopened.ok());
    QCOMPARE(reopened->lost, QStringList());
    QVERIFY(reopened->state == project.state);
    if (project.extras.journal)
        std::ignore = replay(*project.extras.journal);
}

} // namespace

class TestProjectDamage : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void files_data();
    void files();
};

void TestProjectDamage::files_data()
{
    QTest::addColumn<bool>("checksumsFit");
    QTest::addColumn<bool>("obj");
    QTest::newRow("damaged on disk") << false << false;
    QTest::newRow("made to mislead") << true << false;
    QTest::newRow("made to mislead, OBJ") << true << true;
}

void TestProjectDamage::files()
{
    QFETCH(bool, checksumsFit);
    QFETCH(bool, obj);
    const test::Session session = obj ? test::cubeSession() : test::gridSession(24, 30, 4);
    const QByteArray whole = ProjectWriter().bytes(session.state, session.extras);
    const ProjectParts container = readContainer(whole, projectVersion, {}).value();
    const qint64 before = MemoryLimit::inUse();
    checkOpened(parseProject(whole, {}).value());
    const qint64 honest = MemoryLimit::inUse() - before;
    test::Random random(checksumsFit ? 1 : 2);
    int opened = 0;
    const MemoryLimit limit(honest + 8 * 1024 * 1024);
    for (int i = 0; i < filesOfEachKind; ++i) {
        QByteArray bytes = whole;
        if (checksumsFit) {
            auto parts = container.parts;
            const auto part = std::next(parts.begin(), random.below(static_cast<int>(parts.size())));
            damage(part->second, random);
            std::vector<PackedBlock> blocks;
            for (const auto &[name, content] : parts)
                blocks.push_back(packBlock(name, content, name == part->first));
            bytes = containerBytes(projectVersion, blocks);
        } else {
            damage(bytes, random);
        }
        const Result<LoadedProject> loaded = parseProject(bytes, {});
        if (!loaded) {
            QVERIFY2(!loaded.error().message.contains(u"memory"), qPrintable(QString::number(i)));
            continue;
        }
        ++opened;
        if (i % 4 == 0)
            checkOpened(loaded.value());
    }
    QVERIFY2(opened > filesOfEachKind / 10, qPrintable(QString::number(opened)));
}

QTEST_GUILESS_MAIN(TestProjectDamage)

} // namespace tst_projectdamage

#include "tst_projectdamage.moc"
