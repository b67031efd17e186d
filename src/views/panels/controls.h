// Helpers for building panels: rows, buttons and headings that look the same everywhere.
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

//! Space between rows, and between the content of a panel and its border, in device-independent pixels.
inline constexpr int rowSpacing = 4;
inline constexpr int panelMargin = 8;

//! Makes a form layout on `owner` with narrow rows and without margins.
QFormLayout *makeForm(QWidget *owner);
//! Adds a row. The label is the field's buddy, and both have the tooltip. Dragging the label of a number
//! field sideways changes the number.
QLabel *addRow(QFormLayout *form, const QString &label, QWidget *field, const QString &tip);
//! Makes a push button that can be as narrow as its text. \param name object name
QPushButton *makeButton(const QString &text, QLatin1StringView name);
enum class RowWidths { Equal, AsNeeded };
//! Makes a row of widgets.
QWidget *makeRow(std::initializer_list<QWidget *> widgets, RowWidths widths = RowWidths::Equal);
//! Makes a section heading: bold, with a line.
QWidget *makeHeading(const QString &text);
//! Adds a caption and a right-aligned value to a grid, both with the tooltip.
//! \param column of the caption; the value is in the next one \returns the label of the value
QLabel *addFigure(QGridLayout *grid, int row, int column, const QString &caption, const QString &tip);
//! Makes a label with several lines in the colour of remarks.
QLabel *makeRemark(const QString &text = {});

} // namespace autocuts
