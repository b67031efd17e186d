#include "views/tools/islanddrag.h"

#include <QCoreApplication>
#include <QKeyEvent>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace autocuts {

namespace {

constexpr double smallestFactor = 1e-3;
//! Pixels. Closer to the pivot, the mouse gives no direction. Chosen by hand.
constexpr double nearPivot = 8;
//! Pixels. Mouse movement that doubles the size when the gesture starts at the pivot. Chosen by hand.
constexpr double scaleLength = 60;

//! Translation context of the texts.
struct IslandTexts
{
    Q_DECLARE_TR_FUNCTIONS(IslandTool)
};

double roundedTo(double value, double step)
{
    return std::round(value / step) * step;
}

QString number(double value, int decimals)
{
    // Adding zero turns -0 into 0.
    return QLocale::c().toString(std::round(value * std::pow(10, decimals)) / std::pow(10, decimals) + 0.0,
                                 'f', decimals);
}

} // namespace

bool IslandDrag::takeKey(const QKeyEvent &event)
{
    const int key = event.key();
    if (key >= Qt::Key_0 && key <= Qt::Key_9 && typed.size() < 12) {
        typed += QChar(u'0' + key - Qt::Key_0);
    } else if ((key == Qt::Key_Period || key == Qt::Key_Comma) && !typed.contains(u'.')) {
        typed += u'.';
    } else if (key == Qt::Key_Minus && edit != UvEdit::Scale) { // a negative factor would flip faces
        typed = typed.startsWith(u'-') ? typed.mid(1) : u'-' + typed;
    } else if (key == Qt::Key_Backspace) {
        typed.chop(1);
    } else if (key == Qt::Key_X || key == Qt::Key_Y) {
        const DragAxis wanted = key == Qt::Key_X ? DragAxis::X : DragAxis::Y;
        axis = axis == wanted ? DragAxis::Both : wanted;
    } else {
        return false;
    }
    return true;
}

std::optional<double> IslandDrag::typedNumber() const
{
    if (typed.isEmpty())
        return std::nullopt;
    bool valid = false;
    const double value = typed.toDouble(&valid);
    return valid ? value : edit == UvEdit::Scale ? 1 : 0;
}

Vec2 IslandDrag::displacement() const
{
    if (const auto value = typedNumber()) {
        return axis == DragAxis::Y ? Vec2(0, *value / unit.y()) : Vec2(*value / unit.x(), 0);
    }
    Vec2 move = mouseMove();
    if (snap == SnapTo::Islands)
        move += islandShift;
    else if (snap == SnapTo::Tiles)
        move = snappedPoint(move, snapStep);
    else if (snap != SnapTo::Nothing)
        move = snappedMove(move, box, snapStep);
    if (axis == DragAxis::X)
        move.y() = 0;
    if (axis == DragAxis::Y)
        move.x() = 0;
    return move;
}

double IslandDrag::angle() const
{
    if (const auto value = typedNumber())
        return std::remainder(*value, 360);
    const Vec2 from = start - pivot, to = current - pivot;
    if (to.norm() < 1e-12 || start == current)
        return 0;
    const double before = from.norm() < nearPivot * pixel ? 0 : std::atan2(from.y(), from.x());
    const double turned = (std::atan2(to.y(), to.x()) - before) * 180 / std::numbers::pi;
    const double step = snap == SnapTo::Nothing || snap == SnapTo::Islands ? 0
                        : snap == SnapTo::Grid                             ? 15
                        : snap == SnapTo::Texels                           ? 1
                                                                           : 90;
    return std::remainder(step > 0 ? roundedTo(turned, step) : turned, 360);
}

double IslandDrag::factor() const
{
    double value = 1;
    if (const auto number = typedNumber()) {
        value = *number;
    } else {
        Vec2 reach = start - pivot;
        if (reach.norm() < nearPivot * pixel)
            reach = Vec2(scaleLength * pixel, 0);
        value = 1 + (current - start).dot(reach) / reach.squaredNorm();
        const double step = snap == SnapTo::Nothing || snap == SnapTo::Islands ? 0
                            : snap == SnapTo::Texels                           ? 0.01
                                                                               : 0.1;
        if (step > 0)
            value = roundedTo(value, step);
    }
    return std::clamp(value, smallestFactor, 1 / smallestFactor);
}

Eigen::Affine2d IslandDrag::transform(const Vec2 &about) const
{
    Eigen::Affine2d result = Eigen::Affine2d::Identity();
    if (edit == UvEdit::Move) {
        result.translation() = displacement();
        return result;
    }
    if (edit == UvEdit::Rotate) {
        const double degrees = angle();
        if (degrees == 0)
            return result;
        // Quarter turns are exact; cos(pi / 2) is not exactly 0.
        const double quarters = degrees / 90;
        Eigen::Matrix2d turn = Eigen::Rotation2Dd(degrees * std::numbers::pi / 180).toRotationMatrix();
        if (quarters == std::round(quarters))
            turn = turn.array().round();
        result.linear() = turn;
    } else {
        const double value = factor();
        if (value == 1)
            return result;
        result.linear() = Vec2(axis == DragAxis::Y ? 1 : value, axis == DragAxis::X ? 1 : value).asDiagonal();
    }
    result.translation() = about - result.linear() * about;
    return result;
}

QString IslandDrag::text() const
{
    const QString shown = typed.isEmpty() ? QString() : QStringLiteral(" [%1]").arg(typed);
    if (edit == UvEdit::Rotate)
        return IslandTexts::tr("%1\u00b0").arg(number(angle(), 1)) + shown;
    if (edit == UvEdit::Scale)
        return IslandTexts::tr("\u00d7 %1").arg(number(factor(), 3)) + shown;
    const Vec2 length = displacement().cwiseProduct(unit);
    if (inTexels)
        return IslandTexts::tr("%1, %2 texels").arg(number(length.x(), 1), number(length.y(), 1)) + shown;
    return IslandTexts::tr("%1, %2 UV units").arg(number(length.x(), 4), number(length.y(), 4)) + shown;
}

} // namespace autocuts
