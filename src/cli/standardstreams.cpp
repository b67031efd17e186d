#include "cli/standardstreams.h"

#include <QFile>
#include <QFileInfo>

#include <cstdio>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;

namespace {

Error problem(const QString &what, const QFile &file)
{
    return {what + u": "_s + file.errorString(), {}, 0, u"Check where it leads, and the space there"_s};
}

} // namespace

Result<Done> StandardStreams::take(CliOptions &options)
{
    if (options.output == u"-") {
        QString format = options.outputFormat;
        if (format.isEmpty())
            format = options.input == u"-" ? options.inputFormat : QFileInfo(options.input).suffix();
        options.output = mOutput = mFolder.filePath(u"stdout."_s + format);
    }
    if (options.input != u"-")
        return Done{};
    options.input = mFolder.filePath(u"stdin."_s + options.inputFormat);
    QFile stream, file(options.input);
    if (!stream.open(stdin, QIODevice::ReadOnly))
        return problem(u"the standard input cannot be read"_s, stream);
    const QByteArray content = stream.readAll();
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.flush())
        return problem(u"the standard input cannot be kept"_s, file);
    return Done{};
}

Result<Done> StandardStreams::give() const
{
    QFile file(mOutput), stream;
    if (!hasOutput() || !file.open(QIODevice::ReadOnly))
        return Done{};
    const QByteArray content = file.readAll();
    if (!stream.open(stdout, QIODevice::WriteOnly) || stream.write(content) != content.size() ||
        !stream.flush())
        return problem(u"the standard output cannot be written"_s, stream);
    return Done{};
}

} // namespace autocuts
