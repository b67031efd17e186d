// A spin box for delta, with steps by a factor of two.
#pragma once

#include <QDoubleSpinBox>

namespace autocuts {

//! Shows four significant digits, also of very small numbers ("1.526e-05"). A step doubles or halves the
//! value.
class DeltaSpinBox final : public QDoubleSpinBox
{
    Q_OBJECT

public:
    explicit DeltaSpinBox(QWidget *parent = nullptr);

    void stepBy(int steps) override;
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    QString textFromValue(double value) const override;
    double valueFromText(const QString &text) const override;
    QValidator::State validate(QString &text, int &position) const override;
};

} // namespace autocuts
