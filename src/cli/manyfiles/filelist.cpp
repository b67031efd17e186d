#include "cli/manyfiles/filelist.h"

#include "model/io/meshes/meshfile.h"
#include "model/io/projects/projectfile.h"

#include <QDir>
#include <QDirIterator>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <map>

namespace autocuts::manyfiles {

namespace {

using namespace Qt::Literals::StringLiterals;

bool hasWildcards(const QString &path)
{
    return path.contains(u'*') || path.contains(u'?') || path.contains(u'[');
}

bool isModel(const QString &path, const ManyChoice &choice)
{
    return choice.command == u"replay" ? isProjectPath(path) : isModelName(path);
}

QString expression(const QString &pattern)
{
    QString made;
    for (qsizetype i = 0; i < pattern.size(); ++i) {
        const QChar c = pattern[i];
        const qsizetype end = c == u'[' ? pattern.indexOf(u']', i + 2) : -1;
        if (pattern.mid(i, 3) == u"**/") {
            made += u"(?:.*/)?"_s;
            i += 2;
        } else if (c == u'*') {
            made += u"[^/]*"_s;
        } else if (c == u'?') {
            made += u"[^/]"_s;
        } else if (end > 0) {
            QString set = pattern.mid(i + 1, end - i - 1);
            if (set.startsWith(u'!'))
                set[0] = u'^';
            made += u'[' + set.replace(u'\\', u"\\\\"_s) + u']';
            i = end;
        } else {
            made += QRegularExpression::escape(QString(c));
        }
    }
    return made;
}

//! The part of a pattern before the first folder or name with a wildcard, with the slash behind it.
QString fixedPart(const QString &pattern)
{
    const auto wild = std::find_if(pattern.begin(), pattern.end(), [](QChar c) { return hasWildcards(c); });
    return pattern.left(pattern.left(wild - pattern.begin()).lastIndexOf(u'/') + 1);
}

//! The paths of what is below a folder, from there; hidden files and folders excepted.
QStringList filesBelow(const QString &folder)
{
    QStringList files;
    const QString absolute = QFileInfo(folder).absoluteFilePath();
    QDirIterator each(absolute, QDir::Files, QDirIterator::Subdirectories);
    while (each.hasNext())
        files << QDir(absolute).relativeFilePath(each.next());
    files.sort();
    return files;
}

//! Collects tasks.
class Collecting final
{
public:
    Collecting(const ManyChoice &choice, const QString &folder)
        : mChoice(choice), mOwn(folder.isEmpty() ? QString() : QFileInfo(folder).absoluteFilePath() + u'/')
    {}

    //! Adds a file that was found below a folder: the folder of the batch may be there, too.
    void addFound(const QString &input, const QString &below)
    {
        named = true;
        if (mOwn.isEmpty() || !QFileInfo(input).absoluteFilePath().startsWith(mOwn))
            add(input, below);
    }

    //! \param below the path of the output below the folder of the batch, with the suffix of the input
    void add(const QString &input, const QString &below)
    {
        const QFileInfo file(input);
        named = true;
        const QString known = file.exists() ? file.canonicalFilePath() : file.absoluteFilePath();
        if (mKnown.contains(known))
            return;
        mKnown << known;
        tasks.push_back({input, outputOf(below), file.size(), file.lastModified()});
    }

    std::vector<FileTask> tasks;
    bool named = false; //!< a file was named since this was last set

private:
    //! In the format of the input where that can be written.
    static QString writtenOf(const QString &below)
    {
        const QFileInfo name(below);
        const QString own = name.suffix().toLower(), written = formatToWrite(own);
        const bool stays = written == own || !readableFormats().contains(own);
        return QDir::cleanPath(stays ? below : name.path() + u'/' + name.completeBaseName() + u'.' + written);
    }

    QString outputOf(const QString &below) const
    {
        const QFileInfo name(below);
        QString stem = QDir::cleanPath(name.path() + u'/' + name.completeBaseName());
        const bool makesFolder =
            mChoice.command == u"bake" ||
            std::any_of(mChoice.passed.begin(), mChoice.passed.end(),
                        [](const QString &option) { return option.startsWith(u"--textures"); });
        if (makesFolder)
            return stem;
        if (!mChoice.format.isEmpty())
            return stem + u'.' + mChoice.format;
        if (mChoice.command == u"lightbake")
            return stem + u".exr"_s;
        if (mChoice.command == u"thumbnail")
            return stem + u".png"_s;
        return writtenOf(below);
    }

    const ManyChoice &mChoice;
    QString mOwn;
    QSet<QString> mKnown; //!< paths without links
};

} // namespace

bool isModelName(const QString &path)
{
    static const QStringList formats = readableFormats() + QStringList{QLatin1String(projectSuffix)};
    return formats.contains(QFileInfo(path).suffix().toLower());
}

bool matchesPattern(const QString &path, const QString &pattern)
{
    return QRegularExpression(QRegularExpression::anchoredPattern(expression(pattern)))
        .match(path)
        .hasMatch();
}

Result<std::vector<FileTask>> fileTasks(const ManyChoice &choice, const QString &folder)
{
    Collecting all(choice, folder);
    for (const QString &input : choice.inputs) {
        all.named = false;
        if (QFileInfo(input).isDir()) {
            for (const QString &below : filesBelow(input)) {
                if (isModel(below, choice))
                    all.addFound(QDir(input).filePath(below), below);
            }
        } else if (QFileInfo::exists(input) || !hasWildcards(input)) {
            all.add(input, QFileInfo(input).fileName());
        } else {
            const QString fixed = fixedPart(input);
            for (const QString &below : filesBelow(fixed.isEmpty() ? u"."_s : fixed)) {
                if (matchesPattern(fixed + below, input))
                    all.addFound(fixed + below, below);
            }
        }
        if (!all.named)
            return Error{u"no models found"_s, input, 0, u"Name a file, a folder or a pattern"_s};
    }
    std::map<QString, QString> makers;
    for (const FileTask &task : all.tasks) {
        const auto [place, isNew] = makers.emplace(task.output, task.input);
        if (!isNew)
            return Error{u"the output %1 would be that of %2, too"_s.arg(task.output, place->second),
                         task.input, 0, u"Rename one of them, or do it in another folder"_s};
    }
    return all.tasks;
}

} // namespace autocuts::manyfiles
