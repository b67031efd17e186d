// Neutral greys with one blue accent for selected items, so that only the views use colours with a meaning.
#include "views/ui/theme.h"

#include "views/ui/icons.h"

#include <QApplication>
#include <QListView>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleOption>
#include <QToolTip>

#include <algorithm>

namespace autocuts {

namespace {

//! The colours that a theme defines; others are derived from them.
struct ThemeColors
{
    QRgb window, base, alternateBase, button, text, dimText, disabledText;
    QRgb accent, accentText, link, line, toolTip;
};

constexpr ThemeColors darkColors{0xff2b2d30, 0xff1f2023, 0xff26282b, 0xff3a3d41, 0xffdfe1e5, 0xffa3a7ae,
                                 0xff74787f, 0xff2f6eb5, 0xffffffff, 0xff7db3f2, 0xff17181a, 0xff404348};
constexpr ThemeColors lightColors{0xfff0f0f1, 0xffffffff, 0xfff6f6f7, 0xffe6e7e9, 0xff1d1f22, 0xff5f646b,
                                  0xff9a9ea5, 0xff2f6eb5, 0xffffffff, 0xff1f5da8, 0xffc3c6ca, 0xfffdfdf3};

QPalette paletteOf(const ThemeColors &colors)
{
    QPalette palette{QColor(colors.button), QColor(colors.window)};
    const auto set = [&palette](QPalette::ColorRole role, QRgb color) {
        palette.setColor(role, QColor(color));
    };
    set(QPalette::Window, colors.window);
    set(QPalette::WindowText, colors.text);
    set(QPalette::Base, colors.base);
    set(QPalette::AlternateBase, colors.alternateBase);
    set(QPalette::Text, colors.text);
    set(QPalette::Button, colors.button);
    set(QPalette::ButtonText, colors.text);
    set(QPalette::BrightText, colors.accentText);
    set(QPalette::PlaceholderText, colors.dimText);
    set(QPalette::Highlight, colors.accent);
    set(QPalette::HighlightedText, colors.accentText);
    set(QPalette::Link, colors.link);
    set(QPalette::LinkVisited, colors.link);
    set(QPalette::ToolTipBase, colors.toolTip);
    set(QPalette::ToolTipText, colors.text);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText,
                            QPalette::HighlightedText, QPalette::PlaceholderText})
        palette.setColor(QPalette::Disabled, role, QColor(colors.disabledText));
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(colors.button));
    return palette;
}

QString name(QRgb color)
{
    return QColor(color).name();
}

//! Only for what the palette cannot express. The style handles everything else, including high DPI and focus.
QString styleSheetOf(const ThemeColors &colors)
{
    return QStringLiteral(
               "QToolTip { color: %1; background: %2; border: 1px solid %3; padding: 4px; }"
               "QDockWidget::title { background: %4; padding: 5px 8px; text-align: left; }"
               "QMainWindow::separator { background: %3; width: 3px; height: 3px; }"
               "QMainWindow::separator:hover { background: %5; }"
               "QToolBar { border: none; border-bottom: 1px solid %3; spacing: 2px; padding: 3px; }"
               "QStatusBar::item { border: none; }"
               "QPushButton[primary=\"true\"] { background: %5; color: %8; border: none;"
               " border-radius: 4px; padding: 9px; font-weight: bold; }"
               "QPushButton[primary=\"true\"]:hover, QPushButton[primary=\"true\"]:focus { background: %9; }"
               "QPushButton[primary=\"true\"]:disabled { background: %4; color: %7; }"
               "QSlider::groove:horizontal { background: %3; height: 4px; border-radius: 2px; }"
               "QSlider::sub-page:horizontal { background: %5; border-radius: 2px; }"
               "QSlider::sub-page:horizontal:disabled { background: %3; }"
               "QSlider::handle:horizontal { background: %6; width: 14px; height: 14px;"
               " margin: -5px 0; border-radius: 7px; }"
               "QSlider::handle:horizontal:hover { background: %1; }"
               "QSlider::handle:horizontal:disabled { background: %7; }")
        .arg(name(colors.text), name(colors.toolTip), name(colors.line), name(colors.button),
             name(colors.accent), name(colors.dimText), name(colors.disabledText), name(colors.accentText),
             QColor(colors.accent).lighter(115).name());
}

//! The Fusion style with plainer text and buttons, and with the program's icons in messages.
class StudioStyle final : public QProxyStyle
{
public:
    StudioStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

    int styleHint(StyleHint hint, const QStyleOption *option, const QWidget *widget,
                  QStyleHintReturn *data) const override
    {
        if (hint == SH_EtchDisabledText || hint == SH_DialogButtonBox_ButtonsHaveIcons)
            return 0;
        if (hint == SH_Menu_Scrollable) // Fusion makes further columns, which may leave the screen
            return 1;
        return QProxyStyle::styleHint(hint, option, widget, data);
    }

    //! Fusion draws outlines in a darker window colour, which is invisible on a dark window.
    void drawPrimitive(PrimitiveElement element, const QStyleOption *option, QPainter *painter,
                       const QWidget *widget) const override
    {
        const bool isBox = element == PE_IndicatorCheckBox || element == PE_IndicatorRadioButton;
        if (!isBox || !option || option->palette.window().color().lightness() > 128) {
            QProxyStyle::drawPrimitive(element, option, painter, widget);
            return;
        }
        QStyleOptionButton outlined;
        outlined.QStyleOption::operator=(*option);
        outlined.palette.setColor(QPalette::Window, option->palette.color(QPalette::PlaceholderText));
        QProxyStyle::drawPrimitive(element, &outlined, painter, widget);
    }

    //! The icon of the item under the mouse gets the colour of its text.
    void drawControl(ControlElement element, const QStyleOption *option, QPainter *painter,
                     const QWidget *widget) const override
    {
        const auto *item = qstyleoption_cast<const QStyleOptionMenuItem *>(option);
        if (element != CE_MenuItem || !item || item->icon.isNull() || !(item->state & State_Enabled) ||
            !(item->state & State_Selected)) {
            QProxyStyle::drawControl(element, option, painter, widget);
            return;
        }
        QStyleOptionMenuItem light(*item);
        const int size = pixelMetric(PM_SmallIconSize, option, widget);
        light.icon =
            item->icon.pixmap(QSize(size, size), painter->device()->devicePixelRatio(), QIcon::Selected);
        QProxyStyle::drawControl(element, &light, painter, widget);
    }

    //! Lists get rows as high as those of tables and menus, and push buttons some room beside their texts.
    QSize sizeFromContents(ContentsType type, const QStyleOption *option, const QSize &content,
                           const QWidget *widget) const override
    {
        QSize size = QProxyStyle::sizeFromContents(type, option, content, widget);
        if (type == CT_PushButton)
            size.rwidth() += 12;
        else if (type == CT_ItemViewItem && option && qobject_cast<const QListView *>(widget))
            size.setHeight(std::max(size.height(), option->fontMetrics.height() + 8));
        return size;
    }

    QIcon standardIcon(StandardPixmap pixmap, const QStyleOption *option,
                       const QWidget *widget) const override
    {
        switch (pixmap) {
        case SP_MessageBoxWarning:
            return coloredIcon(QStringLiteral("dialog-warning"));
        case SP_MessageBoxQuestion:
            return coloredIcon(QStringLiteral("dialog-question"));
        case SP_MessageBoxInformation:
            return coloredIcon(QStringLiteral("dialog-information"));
        case SP_MessageBoxCritical:
            return coloredIcon(QStringLiteral("dialog-error"));
        // The style's own are black.
        case SP_ToolBarHorizontalExtensionButton:
            return icon(QStringLiteral("more-right"));
        case SP_ToolBarVerticalExtensionButton:
            return icon(QStringLiteral("more-down"));
        default:
            return QProxyStyle::standardIcon(pixmap, option, widget);
        }
    }
};

} // namespace

void applyTheme(QApplication &application, Theme theme)
{
    constexpr const char *property = "autocutsTheme";
    if (application.property(property) == QVariant(int(theme)))
        return;
    application.setProperty(property, int(theme));
    const ThemeColors &colors = theme == Theme::Dark ? darkColors : lightColors;
    QApplication::setStyle(new StudioStyle);
    const QPalette palette = paletteOf(colors);
    QApplication::setPalette(palette);
    QToolTip::setPalette(palette);
    application.setStyleSheet(styleSheetOf(colors));
}

} // namespace autocuts
