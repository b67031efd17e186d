// The decimal separator in number fields.
#pragma once

#include <QObject>

namespace autocuts {

//! Takes point and comma alike as the decimal separator, typed into any field for decimal numbers of the
//! program, whatever the language of the system.
class DecimalKeys final : public QObject
{
    Q_OBJECT

public:
    explicit DecimalKeys(QObject *parent);

    bool eventFilter(QObject *watched, QEvent *event) override;
};

} // namespace autocuts
