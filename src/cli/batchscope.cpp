#include "cli/batchscope.h"

#include <QRegularExpression>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace autocuts {

namespace {

using namespace Qt::Literals::StringLiterals;

//! The names, those that several have with the number of each behind it: "lid#1", "lid#2".
std::vector<QString> numbered(const std::vector<QString> &names)
{
    std::map<QString, int> count, next;
    for (const QString &name : names)
        ++count[name];
    std::vector<QString> result;
    for (const QString &name : names)
        result.push_back(count[name] > 1 ? u"%1#%2"_s.arg(name).arg(++next[name]) : name);
    return result;
}

//! The names that exist, as an error message lists them.
QString listed(const std::vector<QString> &names)
{
    constexpr qsizetype most = 20;
    std::set<QString> sorted(names.begin(), names.end());
    sorted.erase(QString());
    QStringList list(sorted.begin(), sorted.end());
    const qsizetype more = list.size() - most;
    list = list.mid(0, most);
    if (more > 0)
        list << u"and %1 more"_s.arg(more);
    return list.join(u", "_s);
}

//! Where a name is among names, or among those with numbers; else, where names are that match it as a
//! pattern.
std::vector<std::size_t> indicesOf(const QString &wanted, const std::vector<QString> &names,
                                   const std::vector<QString> &own)
{
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (names[i] == wanted || own[i] == wanted)
            found.push_back(i);
    }
    if (!found.empty())
        return found;
    const QString pattern =
        QRegularExpression::escape(wanted).replace(u"\\*"_s, u".*"_s).replace(u"\\?"_s, u"."_s);
    const QRegularExpression whole(QRegularExpression::anchoredPattern(pattern));
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (whole.match(names[i]).hasMatch())
            found.push_back(i);
    }
    return found;
}

//! Adds faces to a scope, by what they belong to.
class ScopeMaker final
{
public:
    explicit ScopeMaker(const Scene &scene)
        : mScene(scene), mFaces(static_cast<std::size_t>(scene.mesh->faceCount()), false)
    {}

    //! \param kind "object" or "material" \param wanted a name that several have means all of them, one with
    //! a number as of numbered() only that one, one with * or ? all that match \param numbers per face,
    //! indices into names
    std::optional<Error> addNamed(const QString &kind, const QStringList &wanted,
                                  const std::vector<QString> &names, const std::vector<int> &numbers)
    {
        const std::vector<QString> own = numbered(names);
        std::vector<bool> chosen(names.size(), false);
        for (const QString &name : wanted) {
            const std::vector<std::size_t> found = indicesOf(name, names, own);
            for (const std::size_t i : found)
                chosen[i] = true;
            if (found.empty()) {
                const QString known = listed(own);
                return problem(u"there is no %1 \"%2\""_s.arg(kind, name),
                               known.isEmpty() ? u"The file names no %1s"_s.arg(kind)
                                               : u"The file has the %1s: %2"_s.arg(kind, known));
            }
        }
        add(numbers, chosen);
        return {};
    }

    std::optional<Error> addIslands(const std::vector<int> &wanted)
    {
        if (wanted.empty())
            return {};
        if (!mScene.hasUv())
            return problem(u"the file has no UVs, so there are no islands"_s,
                           u"Name objects or materials after --only"_s);
        const ChartMap charts = findCharts(*mScene.mesh, mScene.uvSets.front().uv);
        std::vector<bool> chosen(static_cast<std::size_t>(charts.count), false);
        for (int island : wanted) {
            if (island > charts.count)
                return problem(u"there is no island %1"_s.arg(island),
                               u"The map has the islands 1 to %1"_s.arg(charts.count));
            chosen[static_cast<std::size_t>(island - 1)] = true;
        }
        add(charts.faceChart, chosen);
        return {};
    }

    std::vector<bool> take() { return std::move(mFaces); }

private:
    //! \param numbers per face; negative: none
    void add(const std::vector<int> &numbers, const std::vector<bool> &chosen)
    {
        for (std::size_t f = 0; f < numbers.size(); ++f) {
            if (numbers[f] >= 0 && chosen[static_cast<std::size_t>(numbers[f])])
                mFaces[f] = true;
        }
    }

    Error problem(const QString &what, const QString &remedy) const { return {what, mScene.path, 0, remedy}; }

    const Scene &mScene;
    std::vector<bool> mFaces;
};

} // namespace

Result<std::shared_ptr<const JobScope>> batchScope(const CliOptions &options, const Scene &scene)
{
    if (options.only.isEmpty())
        return std::shared_ptr<const JobScope>();
    ScopeMaker maker(scene);
    for (const std::optional<Error> &problem :
         {maker.addNamed(u"object"_s, options.only.objects, scene.objectNames, scene.mesh->faceObject),
          maker.addNamed(u"material"_s, options.only.materials, scene.materialNames, scene.faceMaterial),
          maker.addIslands(options.only.islands)}) {
        if (problem)
            return *problem;
    }
    return std::make_shared<const JobScope>(JobScope{maker.take(), options.borderAttached});
}

ChartMap chartsAlong(const JobScope &scope, ChartMap charts)
{
    std::map<std::pair<int, bool>, int> parts; // chart and side of the border
    for (std::size_t f = 0; f < charts.faceChart.size(); ++f) {
        int &chart = charts.faceChart[f];
        if (chart >= 0)
            chart = parts.try_emplace({chart, scope.faces[f]}, static_cast<int>(parts.size())).first->second;
    }
    charts.count = static_cast<int>(parts.size());
    return charts;
}

bool holdsWholeChart(const JobScope &scope, const ChartMap &charts)
{
    const auto faces = charts.faces();
    return std::any_of(faces.begin(), faces.end(), [&](const std::vector<int> &chart) {
        return std::all_of(chart.begin(), chart.end(), [&](int face) { return scope.faces[face]; });
    });
}

} // namespace autocuts
