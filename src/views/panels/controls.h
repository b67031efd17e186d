// Small helpers for building panels: rows, buttons, headings that look the same everywhere.
#pragma once

#include <QLatin1StringView>
#include <QString>

#include <initializer_list>

class QFormLayout;
class QGridLayout;
class QLabel;
class QPushButton;
class QWidget;

namespace autocuts {

//! Space between rows, and between a panel's content and its border, in device-independent pixels.
inline constexpr int rowSpacing = 4;
inline constexpr int panelMargin = 8;

//! A form layout on owner with narrow rows and without margins.
QFormLayout *makeForm(QWidget *owner);
//! Adds a row whose label is the field's buddy; both show the tip.
QLabel *addRow(QFormLayout *form, const QString &label, QWidget *field, const QString &tip);
//! A push button that may become as narrow as its text. \param name object name
QPushButton *makeButton(const QString &text, QLatin1StringView name);
enum class RowWidths { Equal, AsNeeded };
//! Widgets beside each other.
QWidget *makeRow(std::initializer_list<QWidget *> widgets, RowWidths widths = RowWidths::Equal);
//! Title of a section, bold, with a line.
QWidget *makeHeading(const QString &text);
//! A caption and a value beside it in a grid, the value aligned to the right, both with the tip.
//! \param column of the caption; the value gets the next one \returns the label of the value
QLabel *addFigure(QGridLayout *grid, int row, int column, const QString &caption, const QString &tip);
//! A label in several lines in the colour of remarks.
QLabel *makeRemark(const QString &text = {});

} // namespace autocuts
