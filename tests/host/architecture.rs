//! Arrows between files, read from what each file imports and which methods it calls that another
//! file adds to a type: within a folder they make no ring, and between the modules of a package they
//! point down.

use std::{
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};
use syn::{Attribute, Item, UseTree, visit::Visit};

/// The order of a package.
struct Layers {
    /// Its folder.
    package: &'static str,
    /// Its modules from the bottom up: each imports only modules that stand before it.
    modules: &'static [&'static str],
}

/// The order of every package.
const LAYERS: &[Layers] = &[
    Layers {
        package: "src",
        modules: &["device", "renderer"],
    },
    Layers {
        package: "src/app",
        modules: &[
            "device",
            "file_list",
            "dropped",
            "font",
            "android",
            "frame_times",
            "gesture",
            "host_window",
            "message",
            "live",
            "views",
            "orbit",
            "pacing",
            "playback",
            "action",
            "scene",
            "painter",
            "drift_check",
            "frame_sync",
            "frame_clock",
            "quality_control",
            "screenshot",
            "captures",
            "question",
            "survey",
            "options",
            "recovery",
            "tap_gesture",
            "input",
            "ui",
            "viewer",
            "window",
            "android_entry",
        ],
    },
    Layers {
        package: "src/capture",
        modules: &[
            "limits",
            "left_out",
            "error",
            "header",
            "lens",
            "calibration",
            "decode",
            "mask",
            "picture",
            "poses",
            "template",
            "layouts",
            "split",
            "capture",
            "check",
            "look",
            "units",
            "open",
            "truth",
            "write",
        ],
    },
    Layers {
        package: "src/cli",
        modules: &[
            "advice",
            "assets",
            "backend",
            "files",
            "gone",
            "groups",
            "interrupt",
            "options",
            "backdrop",
            "output",
            "picture",
            "progress",
            "budget",
            "distil",
            "kept",
            "source",
            "spellings",
            "compare",
            "thumbnail",
            "inspect",
            "devices",
            "bake",
            "dataset",
            "evaluate_video",
            "evaluate",
            "bench",
            "capture",
            "convert",
            "export_ply",
            "pack",
            "prune",
            "export",
            "import",
            "camera_path",
            "cast",
            "render",
            "soak",
            "dropped",
            "view",
            "live",
            "train",
            "program",
        ],
    },
    Layers {
        package: "src/core",
        modules: &[
            "constants",
            "hash",
            "random",
            "each",
            "avatar",
            "layout",
            "scene",
            "frame",
            "reference",
            "io",
            "demo",
        ],
    },
    Layers {
        package: "src/demo",
        modules: &[],
    },
    Layers {
        package: "src/formats",
        modules: &[
            "capture",
            "fault",
            "json",
            "gltf",
            "zip_file",
            "guess",
            "bvh",
            "npz",
            "pickle",
            "smpl_joints",
            "smpl",
            "scene_tree",
            "gltf_motion",
            "fbx",
            "retarget",
            "splats",
            "webavatar",
            "mmlphuman",
            "wanted",
            "source",
            "cameras",
            "content",
            "read",
            "open",
        ],
    },
    Layers {
        package: "src/learn",
        modules: &[
            "bake",
            "likeness",
            "ground_truth",
            "pictures",
            "levels",
            "score",
            "prune",
            "distil",
        ],
    },
    Layers {
        package: "src/lab",
        modules: &["sorts", "training", "stress", "verdict", "commands"],
    },
    Layers {
        package: "src/math",
        modules: &[
            "color",
            "covariance",
            "matrix",
            "noise",
            "pca",
            "sampling",
            "partition",
            "poses",
            "spacing",
            "splatter",
            "facing",
            "weights",
        ],
    },
    Layers {
        package: "src/measure",
        modules: &[
            "bytes",
            "chart",
            "coverage",
            "error",
            "flip",
            "setting",
            "viewpoint",
            "similarity",
            "report",
            "table",
            "flicker",
            "soak",
            "bench",
            "packing",
            "rates",
            "steps",
            "survey",
        ],
    },
    Layers {
        package: "src/train",
        modules: &[
            "adam",
            "loss",
            "topology",
            "parameters",
            "view",
            "data",
            "exposure",
            "refine",
            "gpu",
            "lock",
            "prune",
            "start",
            "recipe",
            "perceptual",
            "checkpoint",
            "reference",
            "log",
            "watch",
            "preflight",
            "error",
            "session",
            "refit",
        ],
    },
    Layers {
        package: "src/perceptual",
        modules: &[
            "error",
            "planes",
            "synthetic",
            "dssim",
            "network",
            "maps",
            "gemm",
            "convolution",
            "blur",
            "pool",
            "thin",
            "head",
            "weights",
            "reference",
            "check",
            "perceptual",
        ],
    },
    Layers {
        package: "src/render",
        modules: &["ndk", "quirks", "vulkan", "webgpu"],
    },
    Layers {
        package: "src/runtime",
        modules: &[
            "cache",
            "capture",
            "ndk",
            "slow_start",
            "governor",
            "thermals",
            "trace",
        ],
    },
    Layers {
        package: "src/web",
        modules: &["motion", "panics", "surface", "avatar_canvas"],
    },
    Layers {
        package: "src/web_import",
        modules: &["body", "import", "exports"],
    },
    Layers {
        package: "src/wgsl",
        modules: &["modules", "translate"],
    },
    Layers {
        package: "tools/shaders",
        modules: &[],
    },
];

/// Methods of other packages' types, called as one that a file of ours adds to a type is.
const FOREIGN_CALLS: &[ForeignCall] = &[ForeignCall {
    file: "io::file::order",
    // Of the header that safetensors reads.
    method: "tensors",
}];

/// See [`FOREIGN_CALLS`].
struct ForeignCall {
    /// The file that calls it.
    file: &'static str,
    method: &'static str,
}

/// A path as a file writes it.
struct Import {
    /// Segments, the first of which is `crate`, `super` or `self`, or a module beside the file.
    path: Vec<String>,
    /// Modules written inside the file, around the path.
    inside: Vec<String>,
    /// The name that a re-export of what a module below the file defines has; None for what the
    /// file takes for itself.
    handed_on: Option<String>,
}

/// Methods that a file gives a type.
struct MethodBlock {
    type_name: String,
    methods: BTreeSet<String>,
}

/// A call of a method.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord)]
struct Call {
    method: String,
    /// It is called of a variable, `self` among them, and not of a field or another call's result.
    of_variable: bool,
}

/// A source file as the test sees it.
struct Source {
    file: PathBuf,
    /// Names of the module and those around it, from the package's root.
    module: Vec<String>,
    imports: Vec<Import>,
    /// What it defines at its top, modules written inside it among them.
    defines: BTreeSet<String>,
    /// Names that it re-exports, with the path that each stands for; a glob has the name `*`.
    exports: Vec<(String, Vec<String>)>,
    /// Names that it writes outside of imports.
    names: BTreeSet<String>,
    /// What it implements, traits aside.
    blocks: Vec<MethodBlock>,
    calls: BTreeSet<Call>,
}

fn for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute
                .parse_args::<syn::Path>()
                .is_ok_and(|path| path.is_ident("test") || path.is_ident("doc"))
    })
}

/// Every path of a tree of imports, with the name that it is known by afterwards.
fn leaves(tree: &UseTree, before: &[String], found: &mut Vec<(String, Vec<String>)>) {
    let with = |name: String| {
        let mut path = before.to_vec();
        if name != "self" || path.is_empty() {
            path.push(name);
        }
        path
    };
    match tree {
        UseTree::Path(path) => leaves(&path.tree, &with(path.ident.to_string()), found),
        UseTree::Name(name) => {
            let path = with(name.ident.to_string());
            found.push((path.last().cloned().unwrap_or_default(), path));
        }
        UseTree::Rename(rename) => {
            found.push((rename.rename.to_string(), with(rename.ident.to_string())));
        }
        UseTree::Glob(_) => found.push(("*".into(), before.to_vec())),
        UseTree::Group(group) => {
            for tree in &group.items {
                leaves(tree, before, found);
            }
        }
    }
}

impl Source {
    fn read(file: PathBuf, module: Vec<String>) -> Self {
        let text = fs::read_to_string(&file).expect("a source file can be read");
        let syntax = syn::parse_file(&text).expect("a source file is Rust");
        let mut source = Self {
            file,
            module,
            imports: Vec::new(),
            defines: BTreeSet::new(),
            exports: Vec::new(),
            names: BTreeSet::new(),
            blocks: Vec::new(),
            calls: BTreeSet::new(),
        };
        for item in &syntax.items {
            source.define(item);
        }
        let mut reader = Reader {
            source: &mut source,
            inside: Vec::new(),
        };
        reader.visit_file(&syntax);
        source
    }

    fn define(&mut self, item: &Item) {
        let name = match item {
            Item::Const(item) => &item.ident,
            Item::Enum(item) => &item.ident,
            Item::Fn(item) => &item.sig.ident,
            Item::Macro(item) => match &item.ident {
                Some(name) => name,
                None => return,
            },
            Item::Mod(item) if item.content.is_some() => &item.ident,
            Item::Static(item) => &item.ident,
            Item::Struct(item) => &item.ident,
            Item::Trait(item) => &item.ident,
            Item::Type(item) => &item.ident,
            Item::Union(item) => &item.ident,
            _ => return,
        };
        self.defines.insert(name.to_string());
    }
}

struct Reader<'a> {
    source: &'a mut Source,
    inside: Vec<String>,
}

impl<'a> Visit<'a> for Reader<'_> {
    fn visit_item(&mut self, item: &'a Item) {
        let attributes: &[Attribute] = match item {
            Item::Mod(item) => &item.attrs,
            Item::Use(item) => &item.attrs,
            Item::Fn(item) => &item.attrs,
            Item::Impl(item) => &item.attrs,
            _ => &[],
        };
        if !for_tests(attributes) {
            syn::visit::visit_item(self, item);
        }
    }

    fn visit_item_mod(&mut self, item: &'a syn::ItemMod) {
        self.inside.push(item.ident.to_string());
        syn::visit::visit_item_mod(self, item);
        self.inside.pop();
    }

    fn visit_item_impl(&mut self, item: &'a syn::ItemImpl) {
        if let (None, syn::Type::Path(of)) = (&item.trait_, &*item.self_ty)
            && let Some(last) = of.path.segments.last()
        {
            // What is private is called by the file alone, or by those below it.
            let methods = item.items.iter().filter_map(|item| match item {
                syn::ImplItem::Fn(function)
                    if !matches!(function.vis, syn::Visibility::Inherited) =>
                {
                    Some(function.sig.ident.to_string())
                }
                _ => None,
            });
            self.source.blocks.push(MethodBlock {
                type_name: last.ident.to_string(),
                methods: methods.collect(),
            });
        }
        syn::visit::visit_item_impl(self, item);
    }

    fn visit_expr_method_call(&mut self, call: &'a syn::ExprMethodCall) {
        self.source.calls.insert(Call {
            method: call.method.to_string(),
            of_variable: matches!(&*call.receiver, syn::Expr::Path(_)),
        });
        syn::visit::visit_expr_method_call(self, call);
    }

    fn visit_item_use(&mut self, item: &'a syn::ItemUse) {
        let mut found = Vec::new();
        leaves(&item.tree, &[], &mut found);
        let public = !matches!(item.vis, syn::Visibility::Inherited);
        for (name, path) in found {
            // `self::below` and `below` are a module below.
            let below = public && !["crate", "super"].contains(&path[0].as_str());
            let handed_on = below.then(|| name.clone());
            if self.inside.is_empty() {
                self.source.exports.push((name, path.clone()));
            }
            self.source.imports.push(Import {
                path,
                inside: self.inside.clone(),
                handed_on,
            });
        }
    }

    fn visit_path(&mut self, path: &'a syn::Path) {
        let segments: Vec<_> = path
            .segments
            .iter()
            .map(|part| part.ident.to_string())
            .collect();
        self.source.names.insert(segments[0].clone());
        if segments.len() > 1 {
            self.source.imports.push(Import {
                path: segments,
                inside: self.inside.clone(),
                handed_on: None,
            });
        }
        syn::visit::visit_path(self, path);
    }
}

/// The files of a package, by the names of their modules.
struct Package {
    sources: BTreeMap<Vec<String>, Source>,
}

impl Package {
    /// `folder`: where the package's root is; folders that are packages themselves are left out.
    fn read(folder: &Path) -> Self {
        let mut sources = BTreeMap::new();
        let mut folders = vec![(folder.to_path_buf(), Vec::new())];
        while let Some((folder, module)) = folders.pop() {
            for entry in fs::read_dir(&folder)
                .expect("a source folder can be read")
                .flatten()
            {
                let path = entry.path();
                let name = entry.file_name().to_string_lossy().into_owned();
                if path.is_dir() {
                    if !path.join("Cargo.toml").exists() {
                        let below = [module.clone(), vec![name]].concat();
                        folders.push((path, below));
                    }
                } else if let Some(stem) = name.strip_suffix(".rs") {
                    let own = match stem {
                        "build" if module.is_empty() => continue,
                        "main" if module.is_empty() && folder.join("lib.rs").exists() => continue,
                        "lib" | "main" if module.is_empty() => Vec::new(),
                        "mod" => module.clone(),
                        _ => [module.clone(), vec![stem.to_owned()]].concat(),
                    };
                    sources.insert(own.clone(), Source::read(path, own));
                }
            }
        }
        Self { sources }
    }

    /// The module of the file that defines what a path, from the package's root, names.
    fn resolve(&self, path: &[String], depth: usize) -> Option<Vec<String>> {
        let mut module = Vec::new();
        for (at, name) in path.iter().enumerate() {
            let below = [module.clone(), vec![name.clone()]].concat();
            if self.sources.contains_key(&below) {
                module = below;
                continue;
            }
            let source = self.sources.get(&module)?;
            if source.defines.contains(name) || depth > 8 {
                return Some(module);
            }
            for (known, target) in &source.exports {
                if known == name {
                    let target = self.absolute(source, &[], target)?;
                    let whole = [target, path[at + 1..].to_vec()].concat();
                    return self.resolve(&whole, depth + 1);
                }
            }
            for (known, target) in &source.exports {
                if known == "*" {
                    let target = self.absolute(source, &[], target)?;
                    let found = self.resolve(&target, depth + 1);
                    if let Some(found) = found
                        && self.sources[&found].defines.contains(name)
                    {
                        return Some(found);
                    }
                }
            }
            return Some(module);
        }
        Some(module)
    }

    /// A path from the package's root. None for paths into other packages.
    fn absolute(&self, source: &Source, inside: &[String], path: &[String]) -> Option<Vec<String>> {
        let mut base = [source.module.clone(), inside.to_vec()].concat();
        match path.first()?.as_str() {
            "crate" => Some(path[1..].to_vec()),
            "super" | "self" => {
                let mut rest = path;
                while let Some(first) = rest.first() {
                    match first.as_str() {
                        "super" => {
                            base.pop()?;
                        }
                        "self" => {}
                        _ => break,
                    }
                    rest = &rest[1..];
                }
                Some([base, rest.to_vec()].concat())
            }
            name => {
                // A module below this one, or a name that an import brought.
                let below = [base.clone(), vec![name.to_owned()]].concat();
                self.sources
                    .contains_key(&below)
                    .then(|| [base, path.to_vec()].concat())
            }
        }
    }

    /// The module of the file that defines a type, as a file names it.
    fn definition(&self, source: &Source, type_name: &str) -> Option<Vec<String>> {
        let path = [source.module.clone(), vec![type_name.to_owned()]].concat();
        let found = self.resolve(&path, 0)?;
        self.sources[&found]
            .defines
            .contains(type_name)
            .then_some(found)
    }

    /// The methods that files add to types of other files.
    fn added_methods(&self) -> Vec<AddedMethod<'_>> {
        let mut added = Vec::new();
        for (module, source) in &self.sources {
            for block in &source.blocks {
                let Some(of) = self.definition(source, &block.type_name) else {
                    continue;
                };
                if of == *module {
                    continue;
                }
                for method in &block.methods {
                    // Only calls of variables may be told apart from those of other types' methods
                    // of the name.
                    let elsewhere = self.sources.values().any(|other| {
                        other.blocks.iter().any(|other| {
                            other.methods.contains(method) && other.type_name != block.type_name
                        })
                    });
                    added.push(AddedMethod {
                        module,
                        of: of.clone(),
                        type_name: &block.type_name,
                        method,
                        elsewhere,
                    });
                }
            }
        }
        added
    }

    /// Whether a file calls a method that another one adds to a type.
    fn calls(&self, source: &Source, added: &AddedMethod) -> bool {
        let knows = source.module == added.of
            || self.definition(source, added.type_name).as_ref() == Some(&added.of);
        let foreign = FOREIGN_CALLS
            .iter()
            .any(|call| call.method == added.method && call.file == source.module.join("::"));
        let called = !foreign
            && source
                .calls
                .iter()
                .any(|call| call.method == added.method && (call.of_variable || !added.elsewhere));
        let named = source.imports.iter().any(|import| {
            import
                .path
                .ends_with(&[added.type_name.to_owned(), added.method.to_owned()])
                || (source.module == added.of
                    && import.path == ["Self".to_owned(), added.method.to_owned()])
        });
        knows && (called || named)
    }

    /// Arrows: the modules that each file takes something from.
    fn arrows(&self) -> BTreeMap<&Vec<String>, BTreeSet<Vec<String>>> {
        let added = self.added_methods();
        let mut arrows = BTreeMap::new();
        for (module, source) in &self.sources {
            let mut to = BTreeSet::new();
            for import in &source.imports {
                // What is only handed on is not taken.
                if let Some(name) = &import.handed_on
                    && !source.names.contains(name)
                {
                    continue;
                }
                let path = self.absolute(source, &import.inside, &import.path);
                if let Some(target) = path.and_then(|path| self.resolve(&path, 0))
                    && target != *module
                {
                    to.insert(target);
                }
            }
            for added in &added {
                if added.module != module && self.calls(source, added) {
                    to.insert(added.module.clone());
                }
            }
            arrows.insert(module, to);
        }
        arrows
    }
}

/// A method that a file adds to a type of another file.
struct AddedMethod<'a> {
    /// The file that adds it.
    module: &'a Vec<String>,
    /// The file that defines the type.
    of: Vec<String>,
    type_name: &'a str,
    method: &'a str,
    /// Another type of the package has a method of this name.
    elsewhere: bool,
}

/// The entry of a folder that a module is, or is in; a `mod.rs` is an entry `mod` of its folder.
fn entry(folder: &[String], module: &[String], is_folder: bool) -> Option<String> {
    let rest = module.strip_prefix(folder)?;
    match rest.first() {
        Some(name) => Some(name.clone()),
        None if is_folder => Some("mod".into()),
        None => None,
    }
}

/// A ring in a graph, as its names in order, if there is one.
fn ring(graph: &BTreeMap<String, BTreeSet<String>>) -> Option<Vec<String>> {
    fn walk(
        graph: &BTreeMap<String, BTreeSet<String>>,
        at: &str,
        path: &mut Vec<String>,
        done: &mut BTreeSet<String>,
    ) -> Option<Vec<String>> {
        if let Some(start) = path.iter().position(|name| name == at) {
            return Some(path[start..].to_vec());
        }
        if done.contains(at) {
            return None;
        }
        path.push(at.to_owned());
        for next in graph.get(at).into_iter().flatten() {
            if let Some(found) = walk(graph, next, path, done) {
                return Some(found);
            }
        }
        path.pop();
        done.insert(at.to_owned());
        None
    }
    let mut done = BTreeSet::new();
    graph
        .keys()
        .find_map(|name| walk(graph, name, &mut Vec::new(), &mut done))
}

/// Every fault of the packages under `root`, a line each.
fn faults(root: &Path, layers: &[Layers]) -> Vec<String> {
    let mut faults = Vec::new();
    let mut packages: Vec<PathBuf> = ["src", "tools/shaders"]
        .map(PathBuf::from)
        .into_iter()
        .filter(|package| root.join(package).exists())
        .collect();
    for entry in fs::read_dir(root.join("src"))
        .expect("src can be read")
        .flatten()
    {
        if entry.path().join("Cargo.toml").exists() {
            packages.push(Path::new("src").join(entry.file_name()));
        }
    }
    packages.sort();
    for entry in layers {
        if !packages.contains(&PathBuf::from(entry.package)) {
            faults.push(format!("{} has layers and is no package", entry.package));
        }
    }
    for name in packages {
        let package = Package::read(&root.join(&name));
        let arrows = package.arrows();
        let mut folders: BTreeSet<Vec<String>> = BTreeSet::new();
        for module in package.sources.keys() {
            for length in 0..module.len() {
                folders.insert(module[..length].to_vec());
            }
        }
        for folder in &folders {
            let mut graph: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
            let mut why: BTreeMap<(String, String), String> = BTreeMap::new();
            for (from, targets) in &arrows {
                let Some(one) = entry(folder, from, true) else {
                    continue;
                };
                for to in targets {
                    let Some(other) = entry(folder, to, true) else {
                        continue;
                    };
                    if one != other {
                        graph.entry(one.clone()).or_default().insert(other.clone());
                        let file = package.sources[*from]
                            .file
                            .strip_prefix(root)
                            .unwrap_or(Path::new("?"));
                        why.insert(
                            (one.clone(), other),
                            format!("{} -> {}", file.display(), to.join("::")),
                        );
                    }
                }
            }
            while let Some(names) = ring(&graph) {
                let steps: Vec<_> = names
                    .iter()
                    .zip(names.iter().cycle().skip(1))
                    .map(|(one, other)| why[&(one.clone(), other.clone())].clone())
                    .collect();
                faults.push(format!(
                    "{}/{}: a ring of {}: {}",
                    name.display(),
                    folder.join("/"),
                    names.join(", "),
                    steps.join("; ")
                ));
                // The next one without this arrow.
                let last = names[names.len() - 1].clone();
                if let Some(targets) = graph.get_mut(&last) {
                    targets.remove(&names[0]);
                }
            }
        }
        let layers = layers.iter().find(|entry| Path::new(entry.package) == name);
        let Some(Layers { modules, .. }) = layers else {
            faults.push(format!("{} is a package without layers", name.display()));
            continue;
        };
        for known in *modules {
            if !arrows
                .keys()
                .any(|module| module.first().is_some_and(|first| first == known))
            {
                faults.push(format!(
                    "{}: `{known}` has a layer and is no module",
                    name.display()
                ));
            }
        }
        for (from, targets) in &arrows {
            let Some(one) = from.first() else { continue };
            let Some(height) = modules.iter().position(|layer| layer == one) else {
                faults.push(format!("{}: `{one}` is in no layer", name.display()));
                continue;
            };
            for to in targets {
                let above = to
                    .first()
                    .and_then(|other| modules.iter().position(|layer| layer == other));
                if above.is_some_and(|above| above > height) {
                    faults.push(format!(
                        "{}: {} imports {} from above",
                        name.display(),
                        from.join("::"),
                        to.join("::")
                    ));
                }
            }
        }
    }
    faults
}

fn files_and_folders_point_down() {
    let root = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."));
    let faults = faults(root, LAYERS);
    assert!(
        faults.is_empty(),
        "{} faults:\n{}",
        faults.len(),
        faults.join("\n")
    );
}

/// The test would see a ring of files, one of folders, one through a method that a file adds to a
/// type and one through what a file hands on and uses, an arrow up, and layers that fit no package
/// or module.
fn faults_are_found() {
    let folder = tempfile::tempdir().unwrap();
    let core = folder.path().join("src/core");
    for below in ["scene", "frame", "io", "../bare"] {
        fs::create_dir_all(core.join(below)).unwrap();
    }
    let write = |name: &str, text: &str| fs::write(core.join(name), text).unwrap();
    write("Cargo.toml", "");
    write("../bare/Cargo.toml", "");
    write("../bare/lib.rs", "");
    write("lib.rs", "pub mod frame; pub mod scene; mod extra; mod io;");
    write("extra.rs", "");
    write(
        "io/mod.rs",
        "mod file; pub use file::Header; pub struct Kind; fn of(header: Header) -> Kind { Kind }",
    );
    write("io/file.rs", "use super::Kind; pub struct Header(Kind);");
    write("frame/mod.rs", "pub mod plan; pub use plan::Plan;");
    write(
        "frame/plan.rs",
        "pub struct Plan; use crate::scene::camera::Camera;",
    );
    write("scene/mod.rs", "pub mod camera; pub mod posed; mod turn;");
    write(
        "scene/camera.rs",
        "use super::posed::Posed; use crate::frame::Plan; pub struct Camera; \
         impl Camera { fn new() -> Self { let mut new = Camera; new.turn(); new } }",
    );
    write(
        "scene/turn.rs",
        "use super::camera::Camera; impl Camera { pub fn turn(&mut self) {} }",
    );
    write("scene/posed.rs", "pub struct Posed(super::camera::Camera);");
    let layers = [
        Layers {
            package: "src",
            modules: &[],
        },
        Layers {
            package: "src/core",
            modules: &["missing", "scene", "frame", "io"],
        },
        Layers {
            package: "src/gone",
            modules: &[],
        },
    ];
    let found = faults(folder.path(), &layers);
    for expected in [
        "ring of camera, posed",
        "ring of frame, scene",
        "ring of camera, turn",
        "ring of file, mod",
        "imports frame::plan from above",
        "src/bare is a package without layers",
        "src/gone has layers and is no package",
        "`missing` has a layer and is no module",
        "`extra` is in no layer",
    ] {
        assert!(
            found.iter().any(|fault| fault.contains(expected)),
            "no fault says `{expected}`: {found:?}"
        );
    }
}

tests! {
    files_and_folders_point_down,
    faults_are_found,
}
