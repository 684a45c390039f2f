#!/usr/bin/env python3
"""Breaks the renderer on purpose, one fault at a time, and says which of the tests of its invariants notice.

    tests/mutations.py [--build build/release] [NAME ...]
    tests/mutations.py --check [--build build/release] [NAME ...]

Each fault changes one place of a source file, which must be as it was committed; the file is put back whatever
happens. Exits with 1 if a fault stays unnoticed. Takes about a minute for each.

With --check nothing is built or changed: exits with 1, a line for each fault, if its place is not there exactly once, or
if the tests that should notice it do not exist. So says ctest of a change that moves such a place.
"""
import argparse
import os
import subprocess
import sys
from typing import NamedTuple

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


class Fault(NamedTuple):
    name: str
    file: str
    before: str
    after: str
    tests: str  # test filter; at least one of these tests must fail


FAULTS = [
    Fault("a look-up in a map returns two per cent too much", "src/maps/radiance_map.cpp",
          "lerp(fx, texel(i + n), texel(i + n + 1)));", "lerp(fx, texel(i + n), texel(i + n + 1))) * 1.02f;",
          "*Invariant1*"),
    Fault("the first surface's emission counts twice", "src/transport/incident_visitor.h",
          "if (hasArrived_) RadianceVisitor::emitted(path, light);", "RadianceVisitor::emitted(path, light);",
          "*DirectPlusTracedIndirect*"),
    Fault("the broad light traced with the direct light includes the glossy lobes", "src/transport/path_tracer.cpp",
          "path.throughput *= broadShare_;", "", "*IndirectLightAlong*"),
    Fault("the gather forgets the BSDF's density", "src/maps/gather.cpp",
          "mapPdf + (both ? bsdf.pdf : 0)", "mapPdf", "*Oracle*"),
    Fault("surfaces that are hidden from the camera are seen through light paths", "src/transport/ray_queries.cpp",
          "return !at.primitive->visibleToCamera || isScreened(", "return isScreened(", "HiddenFromCamera*"),
    Fault("surfaces that are hidden from the camera block its view of what light paths reach", "src/transport/ray_queries.cpp",
          "distance), at.time, true);", "distance), at.time);", "HiddenFromCamera*"),
    Fault("a ray of the camera's is one no more behind a surface without material", "src/accel/interaction.h",
          "next.fromCamera = ray.fromCamera;", "", "*Alpha*:HiddenFromCamera*"),
    Fault("with a transparent film the sky is seen", "src/transport/light_sampler.cpp",
          "light->visibleToCamera() && seesBackdrop", "light->visibleToCamera()", "*TransparentFilm*"),
    Fault("what is hidden from diffuse rays casts a shadow", "src/accel/geometry_group.cpp",
          "return !primitive.material || !primitive.visibleToDiffuse;", "return !primitive.material;", "HiddenFromDiffuse*"),
    Fault("what is hidden from diffuse rays is not seen in mirrors", "src/accel/accel.cpp",
          "ray.mirrored ? kMirrored : kDiffuse;", "kDiffuse;", "HiddenFromDiffuse*"),
    Fault("light paths meet what is hidden from diffuse rays", "src/transport/bdpt.cpp",
          "ray.mirrored = at.specular && mode == TransportMode::Radiance;", "ray.mirrored = at.specular;\n        if (mode == TransportMode::Importance) ray.mirrored = true;",
          "HiddenFromDiffuse*"),
    Fault("light paths go on from mirrors beside what is hidden from diffuse rays", "src/transport/bdpt.cpp",
          "        if (at.node(accel_).lightEndsBefore) break;\n", "", "HiddenFromDiffuse*"),
    Fault("paths are weighted as if light paths met what is hidden from diffuse rays", "src/transport/bdpt.cpp",
          "        if (other > mostFromLight) return false;\n", "", "HiddenFromDiffuse*"),
    Fault("light paths go on from curves that turn towards each ray", "src/transport/bdpt.cpp",
          "paths.light.size() == kMostVertices || facesRays(hit)) break;", "paths.light.size() == kMostVertices) break;",
          "*BidirectionalCurves*:*CurvesInFurnace*"),
    Fault("light paths find shading normals as they are bent for themselves", "src/transport/bdpt.cpp",
          "const Bsdf seen = bsdf.seenFrom(d);", "const Bsdf& seen = bsdf;", "*BidirectionalLeaningNormals*"),
    Fault("views below the horizon of a shading normal stay there", "src/accel/interaction.cpp",
          "    bsdf.bendFor(wo);\n", "", "LeaningNormalsInFurnace*"),
    Fault("a sky that illuminates nothing lights the scene", "src/transport/light_sampler.cpp",
          "            if (light->illuminates()) infinite_.push_back(light.get());\n        }\n        if (!light->illuminates()) continue;\n",
          "            infinite_.push_back(light.get());\n        }\n", "HiddenFromCamera*"),
    Fault("light paths start at a sky that illuminates nothing", "src/transport/bdpt.cpp",
          "if (!(power > 0) || !light->illuminates()) continue;", "if (!(power > 0)) continue;", "HiddenFromCamera*"),
    Fault("rough diffuse surfaces lose what their grooves scatter more than once", "src/scene/lobes/rough_diffuse.cpp",
          " + repeated_ * (missing * perMissing_);", " + repeated_ * (missing * 0);", "OwnMaterials*"),
    Fault("the principled material's base is smooth", "src/scene/lobes/layered_diffuse.cpp",
          "rough_ ? rough_->f(wo, wi) * kPi : albedo_;", "albedo_;", "OwnMaterials*"),
    Fault("reflections of rough glass are not tinted", "src/scene/materials/material_principled.cpp",
          "MicrofacetDielectric(point.reflectionTint, transmittance,", "MicrofacetDielectric(Rgb(1.f), transmittance,", "OwnMaterials*"),
    Fault("what light paths carry does not fade towards a spot's edge", "src/scene/lights/light_area.cpp",
          "from.uv, 0, emitted(from, d),", "from.uv, 0, emission_.at(from.uv),", "*BidirectionalLights*Radius*"),
    Fault("directions below the horizon of a map with another normal are left out", "src/maps/gather.cpp",
          "glossy || dot(normal, site.n) < kParallel;", "glossy;", "*Invariant1*"),
    Fault("paths of glossy lobes that survive Russian roulette are not weighted up", "src/transport/path_tracer.cpp",
          "return weight * incident(ray, sampler) * (1 / survival);", "return weight * incident(ray, sampler);",
          "*Oracle*"),
    Fault("a sampler depends on its thread", "src/maps/indirect_pass.cpp",
          "    CameraSample sample = cameraSample(sensor_, x, y, stream(x, y, kPrimary), uint32_t(index));",
          "    static thread_local uint32_t calls = 0;\n"
          "    CameraSample sample = cameraSample(sensor_, x, y, stream(x, y, kPrimary), uint32_t(index) + ++calls);", "*Invariant4*"),
    Fault("the maps of earlier passes are kept", "src/maps/indirect_pass.cpp",
          "    captureSites(sites, size_t(maps.pointsThrough(band)) - sites.size(), 0, state);",
          "    captureSites(sites, size_t(maps.pointsThrough(band)) - sites.size(), 0, state);\n"
          "    static std::vector<std::vector<MapSite>> kept;\n"
          "    kept.emplace_back(sites.begin(), sites.end());", "*Invariant5*"),
    Fault("a cache is asked where it does not accept", "src/transport/final_gather.cpp",
          "accepted_ = mayAsk_ && sample_.cache.accepts(point_);", "accepted_ = mayAsk_;", "FinalGather*"),
    Fault("deposits hold light of paths that are as long as the camera's", "src/transport/final_gather.cpp",
          "depth - at_[i].depth < maxDepth - 1;", "depth - at_[i].depth < maxDepth;", "FinalGather*"),
    Fault("paths that go on by the lobes without an answer are not weighted up", "src/transport/final_gather.cpp",
          "        path.throughput *= 1 / survival;\n", "", "FinalGather*"),
    Fault("deposits hold light of lobes that the cache does not answer for", "src/transport/final_gather.cpp",
          "trainings_.scatter(path.weight, trainsHere_ ? part : Rgb(1.f));", "trainings_.scatter(path.weight, Rgb(1.f));",
          "FinalGather*"),
    Fault("paths of final gather are one bounce longer", "src/transport/final_gather.cpp",
          "if (path.depth >= maxDepth_) shown_ = false;", "if (path.depth > maxDepth_) shown_ = false;",
          "FinalGather.WithoutAnswers*"),
    Fault("answers of radiance cells are too bright", "src/cells/radiance_cells.cpp",
          "answer.perFactor = Rgb(cell.perFactor[0], cell.perFactor[1], cell.perFactor[2]);",
          "answer.perFactor = Rgb(cell.perFactor[0], cell.perFactor[1], cell.perFactor[2]) * 1.15f;",
          "*IsNotSeenByFinalGather*"),
    Fault("pixels with more camera samples deposit as often for each", "src/transport/final_gather.cpp",
          "answer.training * sample_.training", "answer.training", "FinalGather*"),
    Fault("images on meshes are sampled without their density", "src/scene/lights/light_area_mesh.cpp", "pdf *= s.density;", "",
          "*Lights*ImageOn*"),
    Fault("light paths start on images by area", "src/scene/lights/light_area_shape.cpp",
          "const float pdf = grid_->density(at.uv) / spot->area;", "const float pdf = 1 / (spot->area * 0 + area_);", "*BidirectionalLights*ImageOn*"),
    Fault("the point of a light sample is taken for another of the image", "src/transport/bdpt.cpp",
          "EmitterHit point{Vec3(0.f), s.ng, s.triangle, s.uv};", "EmitterHit point{Vec3(0.f), s.ng};",
          "*BidirectionalLights*ImageOn*"),
    Fault("light paths reach what stands outside a portal", "src/transport/bdpt.cpp",
          "if (first && light.isInfinite() && isBlack(light.escaped(hit.p, -emitted->d))) break;", "",
          "Portal.Nothing*"),
    Fault("a portal's light is sampled from where the camera is", "src/transport/direct_lighting.cpp",
          "lightPdf *= light.pdfEscaped(from, d);", "lightPdf *= light.pdfEscaped(Vec3(0.f), d);", "*Lights*Portal*"),
    Fault("light that comes through a window is weighted by the density of the whole sky",
          "src/transport/direct_lighting.cpp", "lightPdf *= at.pdf * guide_", "lightPdf *= light.pdfEscaped(from, d) * guide_",
          "EnvironmentWindows.ThatAreWrong*"),
    Fault("directions through two windows count twice", "src/transport/environment_windows.cpp",
          "if (!direction || passedBy(p, direction->wi, shares) != window) return {};", "if (!direction) return {};",
          "EnvironmentWindows.ThatAreWrong*"),
    Fault("the sky is sampled through windows alone", "src/transport/environment_windows.cpp",
          "if (!s || passedBy(p, s->wi, shares) < count()) return {};", "if (!windows_.empty()) return {};",
          "EnvironmentWindows.ThatAreWrong*"),
    Fault("shapes without a material cast shadows", "src/accel/geometry_group.cpp", "    if (isOpenToLight(primitive)) return;\n", "",
          "*SurfacesWithoutAMaterial*"),
    Fault("meshes without a material cast shadows", "src/accel/geometry_group.cpp",
          "return primitive.alpha || primitive.shadowAlpha || isOpenToLight(primitive);",
          "return primitive.alpha || primitive.shadowAlpha;", "*SurfacesWithoutAMaterial*"),
    Fault("paths end at surfaces without a material", "src/transport/to_surface.h",
          "        if (ends) return Arrival::Surface;",
          "        if (ends) return Arrival::Surface;\n        if (!hit.primitive->areaLight) return Arrival::Lost;",
          "*SurfacesWithoutAMaterial*"),
    Fault("mirrored quadrics are inside out", "src/scene/shapes/quadric_space.h", ": flip_(reverseOrientation) {",
          ": flip_(reverseOrientation != objectToWorld.swapsHandedness()) {", "Mirroring*"),
    Fault("rays start at the rounded point", "src/accel/spawn_point.h", "(dot(ng, d) < 0 ? -error : error)", "(0 * dot(ng, d))",
          "Precision*"),
    Fault("rays start too far from their surface", "src/accel/spawn_point.h", "return 8 * 0x1p-23f * largest;",
          "return 256 * 0x1p-23f * largest;", "Precision*"),
    Fault("hits lie on edges", "src/accel/packed_mesh.cpp", "if (!(nearest < far)) return;", "return;", "Precision*"),
    Fault("both sides of a surface see each other", "src/transport/ray_queries.cpp",
          "const Vec3 left = to.towards(-direction) - o;", "const Vec3 left = (to.p - o) * 0.9999f;", "Precision*"),
    Fault("cells keep the light of a lamp that was switched off", "src/cells/radiance_cells.cpp",
          "if (carried_) forgotten_ += carried_->forget(table_, grid_, statistics_);", "",
          "MovingWorld.*"),
    Fault("an old geometry keeps its old primitive", "src/accel/accel.cpp",
          "for (size_t id = 0; id < its.size(); ++id) group.geometries()[id]->primitive = its[id];", "",
          "MovingWorld.*"),
    Fault("a moved mesh is taken for the one before", "src/pbrt/kept_contents.cpp",
          "hasher.add(double(context.objectToWorld.at(row, column)));",
          "hasher.add(double(row == column));", "MovingWorld.*"),
    Fault("scenes far from zero stay there", "src/pbrt/scene_file.cpp", "if (origin == likely) return scene;",
          "return scene;", "Precision*"),
    Fault("light that only shadow rays can find is weighted", "src/transport/direct_lighting.cpp",
          "proposal.screened = accel_.hasShadowMasks()", "proposal.screened = false && accel_.hasShadowMasks()",
          "ShadowMasks*"),
    Fault("negative lobes come in the first samples", "src/scene/filter.cpp", "const uint32_t number = index / kGroups;",
          "const uint32_t number = index / kGroups + 7;", "*FilterOfFurnace*"),
    Fault("alpha between 0 and 1 is opaque", "src/accel/geometry_group.cpp",
          "return value < 1 && uniformOf(ray, data, part) >= value;", "return uniformOf(ray, data, part) >= 1 || value <= 0;", "Alpha*"),
    Fault("normal maps do not follow mirrored coordinates", "src/scene/textures/bump.cpp",
          "dot(alongU.t, at.dpdv) < 0 ? -alongU.t : alongU.t", "alongU.t", "NormalMaps*"),
    Fault("light is not weakened by media on its way to a point", "src/transport/direct_lighting.cpp",
          "if (medium || accel_.hasOpenMedia()) light *=", "if (false) light *=", "Media.*"),
    Fault("direct light has what the second vertex sees of lamps", "src/transport/radiance_visitor.h",
          "if (path.depth > 0 && !direct_)", "if (path.depth > 1 && !direct_)", "*DirectPart*"),
    Fault("media scatter backwards where they should forwards", "src/scene/media/henyey_greenstein.cpp",
          "(g > 0 ? dot(wo, wi) : -dot(wo, wi))", "(g > 0 ? -dot(wo, wi) : dot(wo, wi))", "Media.*"),
    Fault("what is inside of a medium's surface is taken for outside", "src/accel/interaction.h",
          "return dot(ng, d) < 0 ? media.inside : media.outside;", "return dot(ng, d) > 0 ? media.inside : media.outside;",
          "Media.*"),
    Fault("free paths in coloured media are weighted as in grey ones", "src/transport/medium_segment.cpp",
          "const float pdf = dot(shares, density);", "const float pdf = dot(Rgb(1.f / 3), density);", "Media.*"),
    Fault("what paths find out for the cells does not lose what media take", "src/transport/final_gather.cpp",
          "trainings_.scatter(passage.end.weight, Rgb(1.f));",
          "trainings_.scatter(Rgb(passage.end.weight.x > 0 ? 1.f : 0.f), Rgb(1.f));", "Media.*"),
]


def program(build):
    return os.path.join(build, "tests/pipeline_tests")


def complaint(fault, build):
    """What keeps a fault from being tried; None: nothing."""
    path = os.path.join(ROOT, fault.file)
    found = open(path).read().count(fault.before) if os.path.exists(path) else 0
    if found != 1:
        return f"{fault.file} has {'no more' if found == 0 else f'{found} times'}: {fault.before.strip()}"
    if fault.before == fault.after:
        return "it changes nothing"
    listed = subprocess.run([program(build), "--gtest_list_tests", f"--gtest_filter={fault.tests}"],
                            capture_output=True, text=True)
    if listed.returncode:
        return f"{program(build)} does not run: {listed.stderr.strip()}"
    if not any(line.startswith("  ") for line in listed.stdout.splitlines()):
        return f"there are no tests {fault.tests}"
    return None


def check(faults, build):
    """The exit status of --check."""
    if not os.path.exists(program(build)):
        sys.exit(f"{program(build)} is not there: build it first, or give --build")
    complaints = [(f.name, complaint(f, build)) for f in faults]
    for name, text in complaints:
        if text:
            print(f"{name}: {text}")
    return 1 if any(text for _, text in complaints) else 0


def failures(build, tests):
    """The names of the failing tests. Exits if the tests cannot be built or none match."""
    done = subprocess.run(["cmake", "--build", build, "--target", "pipeline_tests"], capture_output=True, text=True)
    if done.returncode:
        sys.exit(done.stdout + done.stderr)
    out = subprocess.run([program(build), f"--gtest_filter={tests}"], capture_output=True, text=True)
    if "[ RUN" not in out.stdout:
        sys.exit(f"there are no tests {tests}")
    failed = [line.split("]")[1].split(",")[0].strip() for line in out.stdout.splitlines() if line.startswith("[  FAILED")]
    return sorted({name.split(" ")[0] for name in failed if "." in name})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="*", metavar="NAME", help="words; only faults whose name contains one of them (default: all)")
    parser.add_argument("--build", default=os.path.join(ROOT, "build/release"), help="the build folder")
    parser.add_argument("--check", action="store_true", help="only look whether each fault can be tried")
    args = parser.parse_args()
    faults = [f for f in FAULTS if not args.names or any(name in f.name for name in args.names)]
    if not faults:
        sys.exit(f"no fault has any of these words: {' '.join(args.names)}")
    if args.check:
        return check(faults, args.build)
    for f in faults:
        if subprocess.run(["git", "-C", ROOT, "diff", "--quiet", "HEAD", "--", f.file]).returncode:
            sys.exit(f"{f.file} has changes that are not committed")
    whole = failures(args.build, ":".join(sorted({f.tests for f in faults})))
    if whole:
        sys.exit(f"these tests fail on the unchanged code: {', '.join(whole)}")
    if check(faults, args.build):
        return 1
    unnoticed = 0
    for f in faults:
        path = os.path.join(ROOT, f.file)
        source = open(path).read()
        try:
            open(path, "w").write(source.replace(f.before, f.after))
            failed = failures(args.build, f.tests)
        finally:
            open(path, "w").write(source)
        unnoticed += not failed
        print(f"{f.name}: " + (f"noticed by {len(failed)}: {', '.join(failed)}" if failed else "NOT NOTICED"), flush=True)
    return 1 if unnoticed else 0


sys.exit(main())
