// A setting of a tool, as the bar of tool options shows it.
#pragma once

#include <QString>
#include <QStringList>

#include <functional>

namespace autocuts {

//! A number, a switch or a choice.
struct ToolOption
{
    QString name, tip; //!< translated
    double value = 0;  //!< of a switch 0 or 1, of a choice the index
    double minimum = 0, maximum = 1;
    QString suffix{};      //!< of a number
    QStringList choices{}; //!< of a choice; otherwise empty
    bool isSwitch = false;
    std::function<void(double)> set; //!< the user chose another value

    static ToolOption number(const QString &name, const QString &tip, double value, double minimum,
                             double maximum, const QString &suffix, std::function<void(double)> set)
    {
        return {name, tip, value, minimum, maximum, suffix, {}, false, std::move(set)};
    }
    static ToolOption toggle(const QString &name, const QString &tip, bool on,
                             std::function<void(double)> set)
    {
        return {name, tip, on ? 1.0 : 0.0, 0, 1, {}, {}, true, std::move(set)};
    }
    static ToolOption choice(const QString &name, const QString &tip, int index, const QStringList &choices,
                             std::function<void(double)> set)
    {
        return {name, tip, double(index), 0, double(choices.size() - 1), {}, choices, false, std::move(set)};
    }
};

} // namespace autocuts
