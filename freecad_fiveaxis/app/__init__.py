# SPDX-License-Identifier: LGPL-2.1-or-later
"""The document side of FreeCAD, with and without a window: functions for macros, and the objects behind them.

Nothing is imported before it is used: numpy and scipy take their time to load.
"""

from __future__ import annotations

from typing import Any

__all__ = [
    "advise", "annotate", "apply_setup", "audit", "compare", "create_setup", "create_toolpath",
    "import_machine", "left_map",
    "post_process", "preview_passes", "prove_signs", "reach_map", "recover", "setup_map", "tessellate",
]  # fmt: skip


def tessellate(obj: Any, stl_path: Any = None, *, overwrite: bool = False, **settings: Any) -> Any:
    """Mesh a solid; returns the Tessellation object.

    ``obj``: a solid, body, compound, mesh or Tessellation (then it is only written). ``stl_path``: write the
    mesh there as well; a file with content is replaced only with ``overwrite``. Settings:
    ``linear_deflection`` mm (0.02), ``angular_deflection`` deg (15), ``faces`` as ("Face3",): what a toolpath
    of it will mill, and ``avoid``: what not. Raises SelectionError, SettingsError, FileError, Cancelled; then
    neither an object nor a file is left behind.
    """
    from . import arguments
    from .actions import tessellate as act

    return act(obj, arguments.file_name_or_none(stl_path), overwrite, settings)


def create_setup(doc: Any, job: Any = None, **settings: Any) -> Any:
    """Machine, controller and work zero for several toolpaths; returns the Setup object.

    Settings: ``machine``, ``controller``, ``origin`` mm, ``tool_length`` mm, ``work_offset``, ``work_zero``
    mm; ``tools``, lines as "T3 ball:6:30 name", without them those of the CAM ``job``, or of the document's
    first one. ``create_toolpath(..., setup=obj)`` links a path to it. Raises FiveAxisError; then the document
    is as it was.
    """
    from . import arguments
    from .job_setup import create as act

    return act(arguments.document(doc), settings, arguments.cam_job(job))


def create_toolpath(doc: Any, base: Any, **settings: Any) -> Any:
    """Return a computed toolpath; returns the Toolpath object.

    ``base``: a solid, body, compound, mesh or Tessellation object, or ``(object, ["Face3"])``. Settings as in
    job files: ``machine="trunnion_ac", cutter="bull:10:2", holder="40x25,63x50", gouge="report",
    scallop=0.01, feed=1000, ...``; also ``work_zero=(x, y, z)`` mm, ``faces``, ``avoid``: faces that are left
    alone, ``linear_deflection`` mm, ``angular_deflection`` deg; ``holder_diameter`` and ``holder_length`` mm
    are a holder of one cylinder. ``setup``: a Setup, whose machine, controller and work zero the path takes;
    in a document with just one Setup it takes that where it is given nothing of the kind; None: none.
    ``fixtures``: solids and meshes of the document that hold the part; the path goes around them.
    ``picked={"pass_centre": (body, "Edge3"), "pass_axis": (body, "Face2")}``: links of radial passes that
    follow the part. Raises FiveAxisError; then the document is as it was.
    """
    from . import arguments
    from .actions import create_toolpath as act

    return act(arguments.document(doc), arguments.base(base), settings)


def preview_passes(base: Any, **settings: Any) -> Any:
    """Return the passes of settings, laid without tool axes, gouge cure, links and NC; returns the core's
    Preview.

    ``point`` (n, 3) mm about the work zero, of lines ``polyline`` (n,); ``passes``, ``length`` mm, ``time`` s
    of cutting alone. Of very many passes one in ``one_in`` is laid; length and time are then estimates of
    all. ``base`` and settings as for :func:`create_toolpath`; or a Toolpath: without settings as it stands,
    else with these for its own. Raises FiveAxisError. The document stays as it is.
    """
    from . import arguments
    from .actions import preview_passes as act

    return act(arguments.base(base), settings)


def advise(toolpath: Any) -> Any:
    """Try what would finish more of a Toolpath's part: other passes, free tool axes, smaller balls; gives the
    core's Trials.

    Each, the best first, has ``changes`` (options as for :func:`create_toolpath`, None: left out),
    ``finished`` and ``gain`` mm2, ``seconds`` of the program, and ``error`` where it cannot be made. Raises
    FiveAxisError, Cancelled. The document stays as it is.
    """
    from .advising import advise as act

    return act(toolpath)


def post_process(toolpath: Any, nc_path: Any, overwrite: bool = False, also: Any = None) -> Any:
    """Write the NC file; returns the NCOutput object. ``also``: further files by name, as bytes; all are
    written or none.

    A file that is there is replaced only where asked, where it is empty, or where it still is what was
    written last. Raises FileError and what the toolpath's computation raises; then the file is as it was.
    """
    from . import arguments
    from .nc_output import post_process as act

    return act(toolpath, arguments.file_name(nc_path), overwrite, arguments.files(also))


def annotate(toolpath: Any) -> Any:
    """Markers at the places worth a look; returns the Markers object, one a path. Raises FiveAxisError."""
    from .actions import annotate as act

    return act(toolpath)


def left_map(toolpath: Any) -> Any:
    """Return what the cutter leaves on the machined surface, and where it takes too much; returns the LeftMap
    object, one a toolpath.

    ``LargestUndercut`` and ``LargestOvercut`` mm, ``UncutArea``, ``OvercutArea`` and ``MachinedArea`` mm2,
    ``UncutVolume`` mm3, ``Verdict`` a sentence. :func:`freecad_fiveaxis.app.rest.heights_of` gives the
    heights themselves, as the core's RestMaterial. Raises FiveAxisError, as SelectionError for what is no
    toolpath; then the document is as it was.
    """
    from .rest import rest_map as act

    return act(toolpath)


def reach_map(base: Any, **settings: Any) -> Any:
    """Where on a part the tool gets at all, and what is in the way elsewhere; returns the ReachMap object,
    computed.

    ``base``: a solid, body, compound, mesh or Tessellation object, ``(object, ["Face3"])``, or a Toolpath,
    whose machine, tool, part and fixtures are taken where no setting says otherwise; ``faces`` and ``avoid``
    are then those of its part. Settings as of
    ``fiveaxis reach``: ``machine``, ``cutter``, ``shank``, ``holder``, ``tool_length``, ``origin``,
    ``table_height``, ``tolerance``, ``boundary``; also ``largest_axis_angle`` deg from Z, ``fixtures``,
    ``faces``, ``avoid``, ``work_zero``, ``linear_deflection`` mm, ``angular_deflection`` deg.
    ``ReachableArea`` mm2, ``ReachableShare`` %, ``StickOut`` mm, ``Verdict`` and ``Advice`` are sentences.
    Raises FiveAxisError; then the document is as it was.
    """
    from . import arguments
    from .reach import reach_map as act

    return act(arguments.base(base), settings)


def audit(doc: Any, nc_path: Any, machine: str, **settings: Any) -> Any:
    """Judge a finished NC file on a machine; returns the Audit object, computed.

    Settings: ``controller``, ``tolerance`` mm, ``method``, ``origin``, ``tool_length``, and ``work_zero``,
    ``shank`` and ``holder`` for the drawing; ``part``: a solid or mesh of the document that the program is
    compared with, about that zero; ``cutter`` [that which the program names]; ``fixtures``: solids and meshes
    of the document that hold the part, which the tool is checked against. Raises FiveAxisError;
    then the document is as it was.
    """
    from . import arguments
    from .actions import audit as act

    return act(arguments.document(doc), arguments.file_name(nc_path), machine, settings)


def setup_map(toolpath: Any, **settings: Any) -> Any:
    """Try where the part of a toolpath could be clamped; returns the SetupMap object, one a toolpath,
    computed.

    Settings: ``region`` (100, 100, 100) mm to either side of the present work zero, ``grid`` (nx, ny, nz)
    places, ``turns`` of the part about Z; ``fixtures``: what holds the part, which the toolpath gets, too
    [those that it has]. ``Recommended`` is the work zero to take, in the machine frame;
    :func:`apply_setup` gives it to the path. Raises FiveAxisError, as SettingsError for a region that leaves
    every limit; then no object is left behind.
    """
    from .setups import setup_map as act

    return act(toolpath, settings)


def apply_setup(setup_map: Any) -> Any:
    """Give the toolpath of a SetupMap the recommended work zero and compute it; returns the toolpath. Raises
    FiveAxisError."""
    from . import arguments
    from .setups import apply as act

    return act(arguments.setup_map(setup_map))


def compare(
    toolpath: Any, machines: Any, cures: Any = (), tool_length: Any = None, fixtures: Any = None
) -> Any:
    """Return the path of a toolpath on several machines, with each cure, with and without tool-centre
    control; returns the rows.

    ``machines``: names or .fcm files; ``cures``: names, without any: all; ``tool_length`` mm, for machines
    with a rotary head; ``fixtures``: objects of the document that hold the part, None: those of the
    toolpath. Each row is a :class:`freecad_fiveaxis.core.studies.compare.Row`. Raises FiveAxisError. The
    document stays as it is.
    """
    from . import arguments
    from .comparing import compare as act

    names = arguments.names(machines), arguments.names(cures)
    return act(toolpath, *names, tool_length, fixtures=fixtures).rows


def recover(cl_file: Any, nc_file: Any, fcm_file: Any = None, **settings: Any) -> Any:
    """Return the machine that a post had in mind, from a CL file (APT) and the program made of it, written as
    a machine file.

    ``fcm_file`` None: a new file in the user's folder of machines; no file is ever replaced. Settings:
    ``machine`` to compare with, ``controller``, ``origin``, ``tool_length`` mm, ``certainty`` mm. Returns the
    core's Recovered (``found``, ``findings``; ``settings.recover.machine_file`` is the file). Raises
    FiveAxisError; then nothing is written.
    """
    from . import arguments, recovering

    cl_file, nc_file = arguments.file_name(cl_file), arguments.file_name(nc_file)
    done = recovering.recover(cl_file, nc_file, arguments.file_name_or_none(fcm_file), settings)
    recovering.write(done)
    return done


def prove_signs(
    nc_file: Any, machine: str, sheet: Any = None, overwrite: bool = False, **settings: Any
) -> Any:
    """Write the program that proves a machine's signs, and its ``sheet`` (.html, .txt or .json); returns the
    core's Proof.

    Settings: ``controller``, ``origin``, ``tool_length``, ``tool``, ``work_offset``, ``mark`` (X, Y, Z) mm,
    ``gap`` mm, ``travel`` mm, ``angle`` deg, ``slow_feed`` mm/min. Raises FiveAxisError, as FileError for a
    file that is there; then nothing is written.
    """
    from . import arguments, signs

    nc_file, sheet = arguments.file_name(nc_file), arguments.file_name_or_none(sheet)
    done = signs.prove(nc_file, {**settings, "machine": machine}, sheet)
    signs.write(done, overwrite)
    return done


def import_machine(source: Any, fcm_file: Any = None, bodies: Any = None) -> str:
    """Make a machine file of a LinuxCNC .ini, a .urdf or a file of FreeCAD's Machine editor; returns its
    name.

    ``fcm_file`` None: a new file in the user's folder of machines; no file is ever replaced. ``bodies``: the
    vismach model of a LinuxCNC .ini, which is read, never run. Meshes of bodies are written beside the
    machine file. Raises FiveAxisError.
    """
    from . import arguments, importing

    source, fcm_file = arguments.file_name(source), arguments.file_name_or_none(fcm_file)
    bodies = arguments.file_name_or_none(bodies)
    return importing.write(importing.read(source, bodies), fcm_file)
