"""Results as JSON: one file for each run while a comparison is going on, and all of it at the end."""

from __future__ import annotations

import json
import math

from .budget import UNITS, Budget
from .result import QUANTITIES, Report, Run, Scene, number_from, opponent_error, runs_of, spread_of


def _number(x: float) -> float | None:
    return float(x) if math.isfinite(x) else None


def _budget_json(budget: Budget) -> dict:
    return {"unit": budget.unit, "amount": float(budget.amount)}


def _run_json(run: Run) -> dict:
    told = {"scene": run.scene, "method": run.method, "budget": _budget_json(run.budget), "repeat": run.repeat}
    if run.failure:
        return told | {"failure": run.failure}
    told["picture"] = run.picture
    if run.oidn_mode:
        told["oidn_mode"] = run.oidn_mode
    told |= {name: _number(getattr(run, name)) for name in QUANTITIES}
    return told | {"mean_ratio": [_number(ratio) for ratio in run.mean_ratio]}


def _run_from(told: dict) -> Run:
    budget = Budget(told["budget"]["unit"], told["budget"]["amount"])
    if budget.unit not in UNITS:
        raise ValueError("no such unit")
    run = Run(told["scene"], told["method"], budget, told["repeat"], told.get("failure", ""))
    if run.failure:
        return run
    run.picture, run.oidn_mode = told["picture"], told.get("oidn_mode", "")
    for name in QUANTITIES:
        setattr(run, name, number_from(told[name]))
    run.mean_ratio = [number_from(told["mean_ratio"][c]) for c in range(3)]
    return run


def _scene_json(scene: Scene) -> dict:
    return {
        "name": scene.name,
        "file": scene.file,
        "width": scene.width,
        "height": scene.height,
        "reference": scene.reference,
        "reference_pair": scene.pair,
        "reference_noise": _number(scene.reference_noise),
        "ssim_noise": _number(scene.ssim_noise),
        "flip_noise": _number(scene.flip_noise),
        "reference_origin": scene.reference_origin,
        "reference_png_kb": _number(scene.reference_png_kb),
        "reference_entropy": _number(scene.reference_entropy),
    }


def _spread_json(report: Report, scene: Scene, method: str, budget: Budget) -> dict | None:
    runs = runs_of(report, scene.name, method, budget)
    if not runs:
        return None
    told = {"scene": scene.name, "method": method, "budget": _budget_json(budget), "count": len(runs)}
    for name in QUANTITIES:
        spread = spread_of([getattr(run, name) for run in runs])
        told[name] = {part: _number(getattr(spread, part)) for part in ("median", "low", "high")}
    error = spread_of([run.error for run in runs]).median
    return told | {"error_by_path_oidn": _number(error / opponent_error(report, scene.name, budget))}


def report_json(report: Report) -> str:
    """All results and their medians. Values that were not measured are null."""
    summary = [
        _spread_json(report, scene, method, budget)
        for scene in report.scenes
        for budget in report.budgets
        for method in report.methods
    ]
    told = {
        "format": "drc-bench-2",
        "version": report.version,
        "processor": report.processor,
        "threads": report.threads,
        "methods": report.methods,
        "scenes": [_scene_json(scene) for scene in report.scenes],
        "runs": [_run_json(run) for run in report.runs],
        "summary": [spread for spread in summary if spread],
    }
    return json.dumps(told, indent=1, ensure_ascii=False) + "\n"


def run_json(run: Run, key: str) -> str:
    """A run, with the key of what made it, so that a later comparison knows whether the run is still valid.

    The key is the command line and the states of the program and of the scene's file.
    """
    told = _run_json(run) | {"key": key, "measured_against": run.measured_against}
    return json.dumps(told, indent=1, ensure_ascii=False) + "\n"


def run_from_json(text: str, key: str) -> Run | None:
    """None if the text is damaged or has another key."""
    try:
        told = json.loads(text)
        if told["key"] != key:
            return None
        run = _run_from(told)
        run.measured_against = told["measured_against"]
        return run
    except (ValueError, KeyError, TypeError, IndexError):
        return None
