#include "support/cliruns.h"

#include "cli/batch.h"
#include "cli/commandline.h"

#include <QFile>
#include <QProcess>

#include <cmath>
#include <numbers>

namespace autocuts::test {

CliRun runInProcess(const QStringList &arguments)
{
    CliRun run;
    const Result<CliOptions> options = parseCommandLine(arguments);
    if (!options)
        return {2, {}, QStringLiteral("autocuts-cli: %1\n").arg(options.error().toString())};
    StopSource stop;
    QTextStream out(&run.out), err(&run.err);
    run.code = runCommand(options.value(), stop, false, out, err);
    return run;
}

CliRun runProgram(const QString &program, const QStringList &arguments)
{
    QProcess process;
    process.start(program, arguments);
    process.closeWriteChannel();
    if (!process.waitForFinished(300'000))
        return {};
    CliRun run{process.exitCode(), QString::fromUtf8(process.readAllStandardOutput()),
               QString::fromUtf8(process.readAllStandardError())};
    if (process.exitStatus() != QProcess::NormalExit)
        run.code = -1;
    return run;
}

QStringList draft(const QString &in, const QString &out)
{
    return {
        QStringLiteral("unwrap"),          in, QStringLiteral("-o"), out, QStringLiteral("--quality=draft"),
        QStringLiteral("--pack-time=0.05")};
}

QByteArray readBytes(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

bool writeBytes(const QString &path, const QByteArray &bytes)
{
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size() && file.flush();
}

QByteArray quadCubeObj()
{
    return "# a cube, as somebody's tool writes it\r\n"
           "mtllib cube.mtl\n"
           "o Cube\n"
           "v 0 0 0\nv 1.000 0 0\nv 1 1e0 0\nv 0 1 0\n"
           "v 0 0 1 # a comment behind\nv 1 0 1\nv +1 1 1\nv 0 1 1\n"
           "vn 0 0 -1\nvn 0 0 1\n"
           "g sides top\n"
           "usemtl red\n"
           "s 1\n"
           "f 1//1 4//1 3//1 2//1\n"
           "f 5//2 6//2 \\\n  7//2 8//2\n"
           "s off\n"
           "f 1 2 6 5\nf  2 3 7 6\n"
           "something that nobody knows\n"
           "f -6 -5 -1 -2\n"
           "f 4 1 5 8";
}

QByteArray sheetObj(int n)
{
    QByteArray text;
    for (int y = 0; y <= n; ++y) {
        for (int x = 0; x <= n; ++x) {
            const double angle = std::numbers::pi * x / n;
            text += "v " + QByteArray::number(std::cos(angle), 'g', 17) + ' ' +
                    QByteArray::number(std::sin(angle), 'g', 17) + ' ' +
                    QByteArray::number(2.0 * y / n, 'g', 17) + '\n';
        }
    }
    for (int y = 0; y < n; ++y) {
        for (int x = 0; x < n; ++x) {
            const int a = y * (n + 1) + x + 1;
            text += "f " + QByteArray::number(a) + ' ' + QByteArray::number(a + 1) + ' ' +
                    QByteArray::number(a + n + 2) + ' ' + QByteArray::number(a + n + 1) + '\n';
        }
    }
    return text;
}

} // namespace autocuts::test
