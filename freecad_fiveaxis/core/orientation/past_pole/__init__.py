# SPDX-License-Identifier: LGPL-2.1-or-later
"""Leads the tool axis through or around the pole, so that the first rotary axis turns little and evenly."""

from .apply import deform_axes
from .choice import ReroutedAxes, reroute_axes
from .trade import Trade, trade_findings, trade_off

__all__ = ["ReroutedAxes", "Trade", "deform_axes", "reroute_axes", "trade_findings", "trade_off"]
