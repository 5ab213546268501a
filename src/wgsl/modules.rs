// The modules for WebGPU, for this package and for the program that compiles them: a name, the source
// below `shaders`, and macros.

/// Macros of a module: names and values.
type Macros = &'static [(&'static str, &'static str)];

/// The sort's first pass.
const FIRST_PASS: Macros = &[("FIRST", "true"), ("TILE", "SORT_TILE")];
/// The passes after it.
const LATER_PASS: Macros = &[("FIRST", "false"), ("TILE", "SORT_TILE")];
/// Any pass.
const ANY_PASS: Macros = &[("TILE", "SORT_TILE")];

macro_rules! web_modules {
    ($each:ident) => {
        $each! {
            MLP = "mlp/mlp", "mlp/mlp.comp", &[];
            MLP_BYTES = "mlp/mlp_bytes", "mlp/mlp_bytes.comp", &[];
            SH_1 = "sh/sh_1", "sh/sh.comp", &[("DEGREE", "1u")];
            SH_2 = "sh/sh_2", "sh/sh.comp", &[("DEGREE", "2u")];
            SH_3 = "sh/sh_3", "sh/sh.comp", &[("DEGREE", "3u")];
            PROJECT = "project/project", "project/project.comp", &[("STORE", "false")];
            PROJECT_STORE = "project/project_store", "project/project.comp", &[("STORE", "true")];
            PROJECT_CACHED = "project/project_cached", "project/project_cached.comp", &[];
            SORT_COUNT = "sort/count", "sort/count.comp", ANY_PASS;
            SORT_REDUCE = "sort/reduce", "sort/reduce.comp", ANY_PASS;
            SORT_SCAN_FIRST = "sort/scan_first", "sort/scan.comp", FIRST_PASS;
            SORT_SCAN_LATER = "sort/scan_later", "sort/scan.comp", LATER_PASS;
            SORT_SCATTER_FIRST = "sort/scatter_first", "sort/scatter.comp", FIRST_PASS;
            SORT_SCATTER_LATER = "sort/scatter_later", "sort/scatter.comp", LATER_PASS;
            SORT_PER_THREAD_COUNT = "sort/per_thread_count", "sort/per_thread_count.comp", LATER_PASS;
            SORT_PER_THREAD_SCATTER_FIRST =
                "sort/per_thread_scatter_first", "sort/per_thread_scatter.comp", FIRST_PASS;
            SORT_PER_THREAD_SCATTER_LATER =
                "sort/per_thread_scatter_later", "sort/per_thread_scatter.comp", LATER_PASS;
            BINNING_COUNT = "binning/count", "binning/count.comp", &[];
            BINNING_SCAN = "binning/scan", "binning/scan.comp", &[];
            BINNING_PAIRS = "binning/pairs", "binning/pairs.comp", &[];
            BINNING_STARTS = "binning/starts", "binning/starts.comp", &[];
            SATURATION = "saturation/saturation", "saturation/saturation.comp", &[];
            SATURATION_DEPTH = "saturation/depth", "saturation/depth.frag", &[];
            QUADS_VERTEX = "raster/quads_vertex", "raster/quads.vert", &[("DEPTH", "false")];
            QUADS_TESTED_VERTEX = "raster/quads_tested_vertex", "raster/quads.vert", &[("DEPTH", "true")];
            QUADS_FRAGMENT = "raster/quads_fragment", "raster/quads.frag", &[];
            RASTER_SHARED = "raster/shared", "raster/shared_rgba8.comp", &[];
            RESOLVE_FRAGMENT = "resolve/resolve", "resolve/resolve.frag", &[];
            PRESENT_VERTEX = "present/present_vertex", "present/present.vert", &[];
            PRESENT_FRAGMENT = "present/present_fragment", "present/present.frag", &[];
        }
    };
}
