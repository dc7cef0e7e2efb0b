# SPDX-License-Identifier: MIT
"""Names of the source report's methods, for people. Every other method goes by its id."""

ENGLISH = {
    "direct": "direct",
    "de_casteljau": "de Casteljau",
    "factorial:power_sum": "via power form",
    "power_sum": "power sum",
    "forward_substitution:de_casteljau": "via Bernstein form, de Casteljau",
    "forward_substitution:direct": "via Bernstein form, direct",
    "factorial+forward_substitution+factorial": "round trip",
}
CHINESE = {
    "direct": "按定义求值",
    "de_casteljau": "de Casteljau 算法",
    "factorial:power_sum": "先转为幂基",
    "power_sum": "幂基逐项求和",
    "forward_substitution:de_casteljau": "先转为 Bernstein 基，再用 de Casteljau",
    "forward_substitution:direct": "先转为 Bernstein 基，再按定义求值",
    "factorial+forward_substitution+factorial": "往返转换",
}
STATISTIC = {
    "mean_error": ("mean error", "平均误差"),
    "max_error": ("largest error", "最大误差"),
    "total_time": ("time", "用时"),
}
# The ids of studies call the forms by the words of the source report.
IN_STUDIES = dict(bernstein="bezier", power="polynomial", rational="rational")
FORM = {"bernstein": ("Bézier curves", "贝塞尔曲线"), "power": ("polynomial curves", "多项式曲线"),
        "rational": ("rational curves", "有理曲线")}


def name(method):
    return ENGLISH.get(method, f"`{method}`")


def form(curve):
    """(English, Chinese) for a kind of curve."""
    return FORM.get(curve, (f"{curve} curves", curve))


def yardstick(curve):
    """The method that the report takes for the truth."""
    return {"bernstein": "direct", "power": "power_sum"}[curve]
