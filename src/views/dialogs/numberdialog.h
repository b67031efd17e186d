// A dialog that asks for one number.
#pragma once

#include <QDialog>

class QDoubleSpinBox;

namespace autocuts {

//! What a NumberDialog asks. All texts are translated.
struct NumberQuestion
{
    QString title;
    QString remark; //!< a line above the number
    QString label;  //!< with its mnemonic
    QString suffix; //!< the unit of the number
    QString action; //!< the button that accepts
    double value = 0, low = 0, high = 1;
    int decimals = 0;
};

//! Asks for one number.
class NumberDialog final : public QDialog
{
    Q_OBJECT

public:
    explicit NumberDialog(const NumberQuestion &question, QWidget *parent = nullptr);

    double number() const;

private:
    QDoubleSpinBox *mNumber;
};

} // namespace autocuts
