#include "cli/manyoptions.h"

#include "cli/optionmakers.h"

#include <QFileInfo>
#include <QRegularExpression>

namespace autocuts {

namespace {

using Group = OptionGroup;
using Problem = std::optional<QString>;

//! Sets a field of the options of a batch.
template <class T>
Field<T> fieldOf(T ManyChoice::*member)
{
    return [member](CliOptions &options) -> T & {
        if (!options.many)
            options.many.emplace();
        return *options.many.*member;
    };
}

} // namespace

std::optional<QString> readManyReport(CliOptions &options, const QString &value)
{
    static const QStringList known{u"csv"_s, u"json"_s, u"html"_s};
    if (!known.contains(QFileInfo(value).suffix()))
        return u"a .csv, .json or .html file"_s;
    options.many->report = value;
    return std::nullopt;
}

std::vector<CliOption> batchOptions()
{
    constexpr Group group = Group::Batching;
    CliOption journal = text(group, {u"--journal"_s}, fieldOf(&ManyChoice::journal),
                             u"folder for the journal, in place of that of the outputs"_s);
    journal.value = u"DIR"_s;
    return {
        {group,
         {u"--report"_s},
         u"FILE"_s,
         u"write what came of all files: .csv, .json, or .html, a page with pictures and figures that sort "
         u"and "
         "filter, and with the difference to the run before"_s,
         {},
         readManyReport},
        defaultingTo(integer(group, u"--jobs"_s, fieldOf(&ManyChoice::jobs), 1, 256,
                             u"files to work on at once; the threads are shared among them"_s),
                     u"one for each core"_s),
        number(group, u"--memory"_s, u"GIGABYTES"_s, fieldOf(&ManyChoice::memory), 0.1, 1e6,
               u"memory for all of them together: large files wait until they fit, one that never does is "
               u"worked on "
               "alone; 100 MB and 150 times the size of a file are expected. Three quarters of what is free "
               "when not given"_s),
        number(group, u"--file-limit"_s, u"SECONDS"_s, fieldOf(&ManyChoice::fileLimit), 0.001, 1e9,
               u"give a file up after this time; --time-limit takes the best map so far"_s),
        flag(group, u"--resume"_s, fieldOf(&ManyChoice::resume), true,
             u"go on with a batch that was ended: what its journal in the folder knows, and has not changed, "
             u"is "
             "not done again"_s),
        {group,
         {u"--retry"_s},
         {},
         u"the same, but do again what failed"_s,
         {},
         [](CliOptions &options, const QString &) -> Problem {
             options.many->resume = options.many->retry = true;
             return std::nullopt;
         }},
        suffixOption(group, u"--format"_s, fieldOf(&ManyChoice::format),
                     u"format of the outputs, for example glb; when not given, that of each input, or obj or "
                     "fbx where that cannot be written"_s),
        {group,
         {u"--part"_s},
         u"K/N"_s,
         u"do only the K-th of N parts of the files, for arrays of jobs; each part has a journal of its own "
         "in the folder, and --resume without --part takes them all over"_s,
         {},
         [](CliOptions &options, const QString &value) -> Problem {
             static const QRegularExpression form(u"^(\\d{1,6})/(\\d{1,6})$"_s);
             const auto match = form.match(value);
             const int part = match.captured(1).toInt(), parts = match.captured(2).toInt();
             if (part < 1 || part > parts)
                 return u"K/N with K from 1 to N"_s;
             options.many->part = part;
             options.many->parts = parts;
             return std::nullopt;
         }},
        journal,
        flag(group, u"--elsewhere"_s, fieldOf(&ManyChoice::elsewhere), true,
             u"leave the work to the program that has started this one, such as autocuts.farm: say on "
             "standard output what is to be done, and read from standard input what came of it"_s),
    };
}

} // namespace autocuts
