// A field of a form with a button beside it.
#pragma once

class QPushButton;
class QWidget;

namespace autocuts {

//! Puts a button, such as Browse, to the right of a field. Enter in the dialog does not press it; the label
//! of the row leads to the field. \param row gets both; null: a new widget \returns the row
QWidget *fieldRow(QWidget *field, QPushButton *button, QWidget *row = nullptr);

} // namespace autocuts
