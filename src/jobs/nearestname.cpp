#include "jobs/nearestname.h"

#include <algorithm>
#include <vector>

namespace autocuts {

namespace {

int changesBetween(const QString &a, const QString &b)
{
    std::vector<std::vector<int>> least(a.size() + 1, std::vector<int>(b.size() + 1));
    for (qsizetype i = 0; i <= a.size(); ++i) {
        for (qsizetype j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                least[i][j] = int(i + j);
                continue;
            }
            least[i][j] = std::min({least[i - 1][j] + 1, least[i][j - 1] + 1,
                                    least[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                least[i][j] = std::min(least[i][j], least[i - 2][j - 2] + 1);
        }
    }
    return least.back().back();
}

} // namespace

QString nearestName(const QString &word, const QStringList &names)
{
    QString nearest;
    int fewest = int(word.size() / 3) + 1;
    for (const QString &name : names) {
        const int changes = changesBetween(word, name);
        if (changes < fewest) {
            fewest = changes;
            nearest = name;
        }
    }
    return nearest;
}

QString didYouMean(const QString &word, const QStringList &names)
{
    const QString nearest = nearestName(word, names);
    return nearest.isEmpty() ? QString() : QStringLiteral(" (did you mean %1?)").arg(nearest);
}

} // namespace autocuts
