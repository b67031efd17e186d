#include "cli/standardstreams.h"

#include <QFile>
#include <QFileInfo>

#include <cstdio>

namespace autocuts {

using namespace Qt::Literals::StringLiterals;
using Command = CliOptions::Command;

namespace {

Error problem(const QString &what, const QFile &file)
{
    return {what + u": "_s + file.errorString(), {}, 0, u"Check where it leads, and the space there"_s};
}

//! The suffix of what goes to standard output.
QString outputFormatOf(const CliOptions &options)
{
    if (!options.outputFormat.isEmpty())
        return options.outputFormat;
    switch (options.command) {
    case Command::Thumbnail:
        return u"png"_s;
    case Command::LightBake:
        return u"exr"_s;
    case Command::Sample:
        return u"obj"_s;
    default:
        return options.input == u"-" ? options.inputFormat : QFileInfo(options.input).suffix();
    }
}

} // namespace

Result<Done> StandardStreams::take(CliOptions &options)
{
    if (options.inputFormat.isEmpty())
        options.inputFormat = options.command == Command::Replay ? u"acproj"_s : u"obj"_s;
    if (options.output == u"-")
        options.output = mOutput = fileFor(u"stdout."_s + outputFormatOf(options));
    if (options.report == u"-")
        options.report = mOutput = fileFor(u"stdout.json"_s);
    if (options.input != u"-" || options.command == Command::Sample)
        return Done{};
    options.input = mInput = fileFor(u"stdin."_s + options.inputFormat);
    QFile stream, file(options.input);
    if (!stream.open(stdin, QIODevice::ReadOnly))
        return problem(u"the standard input cannot be read"_s, stream);
    const QByteArray content = stream.readAll();
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.flush())
        return problem(u"the standard input cannot be kept"_s, file);
    return Done{};
}

QString StandardStreams::fileFor(const QString &name)
{
    if (!mFolder)
        mFolder.emplace();
    return mFolder->filePath(name);
}

Result<Done> StandardStreams::give(bool isMade) const
{
    QFile file(mOutput), stream;
    if (!hasOutput())
        return Done{};
    if (!file.open(QIODevice::ReadOnly))
        return isMade ? Result<Done>(problem(u"what was made cannot be read"_s, file)) : Done{};
    const QByteArray content = file.readAll();
    if (!stream.open(stdout, QIODevice::WriteOnly) || stream.write(content) != content.size() ||
        !stream.flush())
        return problem(u"the standard output cannot be written"_s, stream);
    return Done{};
}

QString StandardStreams::named(QString text) const
{
    if (!mInput.isEmpty())
        text.replace(mInput, u"standard input"_s);
    if (!mOutput.isEmpty())
        text.replace(mOutput, u"standard output"_s);
    return text;
}

} // namespace autocuts
