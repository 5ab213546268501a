//! `core::frame::kernels` against the compiled modules: what each binds, and whether it reads or
//! writes it, found by following every pointer through the module's instructions. Barriers follow
//! from that table, so that a wrong row here is a wrong or missing barrier.

use effigy_core::frame::kernels::{Access, KERNELS, KernelSpec};
use effigy_render::vulkan::shaders::{MODULES, Module};
use rspirv::{
    dr::{self, Instruction, Operand},
    spirv::{Decoration, Op, StorageClass, Word},
};
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// What is known of a binding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Bound {
    is_image: bool,
    access: Access,
}

type Bindings = BTreeMap<u32, Bound>;

/// A module's instructions, and which bindings each of its values points to.
struct Walk<'a> {
    module: &'a dr::Module,
    storage: HashMap<Word, StorageClass>,
    points_to: HashMap<Word, BTreeSet<u32>>,
    bindings: Bindings,
}

impl<'a> Walk<'a> {
    fn new(module: &'a dr::Module) -> Self {
        let mut walk = Self {
            module,
            storage: HashMap::new(),
            points_to: HashMap::new(),
            bindings: Bindings::new(),
        };
        for variable in &module.types_global_values {
            if let (Op::Variable, Some(id), Operand::StorageClass(class)) = (
                variable.class.opcode,
                variable.result_id,
                variable
                    .operands
                    .first()
                    .unwrap_or(&Operand::LiteralBit32(0)),
            ) {
                walk.storage.insert(id, *class);
            }
        }
        for annotation in &module.annotations {
            if let [
                Operand::IdRef(variable),
                Operand::Decoration(Decoration::Binding),
                Operand::LiteralBit32(number),
            ] = annotation.operands[..]
                && walk.storage[&variable] != StorageClass::Uniform
            {
                walk.points_to.insert(variable, BTreeSet::from([number]));
                walk.bindings.entry(number).or_insert(Bound {
                    is_image: walk.storage[&variable] == StorageClass::UniformConstant,
                    access: Access::empty(),
                });
            }
        }
        walk
    }

    fn instructions(&self) -> impl Iterator<Item = &'a Instruction> + use<'a> {
        let functions = &self.module.functions;
        let blocks = functions.iter().flat_map(|function| &function.blocks);
        blocks.flat_map(|block| &block.instructions)
    }

    /// Makes `id` point where `from` does. True if it did not before.
    fn follow(&mut self, id: Word, from: Word) -> bool {
        let known = self.points_to.get(&from).cloned().unwrap_or_default();
        let own = self.points_to.entry(id).or_default();
        let before = own.len();
        own.extend(known);
        own.len() > before
    }

    /// Follows pointers, and images loaded through them, into functions and out of chains.
    fn spread(&mut self) {
        let parameters: HashMap<Word, Vec<Word>> = self
            .module
            .functions
            .iter()
            .filter_map(|function| {
                let parameters = function.parameters.iter();
                let id = function.def.as_ref()?.result_id?;
                Some((id, parameters.filter_map(|p| p.result_id).collect()))
            })
            .collect();
        let mut changes = true;
        while changes {
            changes = false;
            for instruction in self.instructions() {
                match instruction.class.opcode {
                    Op::AccessChain | Op::InBoundsAccessChain | Op::CopyObject | Op::Image => {
                        changes |= self.follow(instruction.result_id.unwrap(), id(instruction, 0));
                    }
                    Op::Load if self.is_image(id(instruction, 0)) => {
                        changes |= self.follow(instruction.result_id.unwrap(), id(instruction, 0));
                    }
                    Op::FunctionCall => {
                        for (at, &parameter) in parameters[&id(instruction, 0)].iter().enumerate() {
                            changes |= self.follow(parameter, id(instruction, at + 1));
                        }
                    }
                    _ => {}
                }
            }
        }
    }

    fn is_image(&self, id: Word) -> bool {
        let mut numbers = self.points_to.get(&id).into_iter().flatten();
        numbers.any(|number| self.bindings[number].is_image)
    }

    /// What every binding is used for.
    fn accesses(mut self) -> Bindings {
        self.spread();
        for instruction in self.instructions() {
            for (at, operand) in instruction.operands.iter().enumerate() {
                let Operand::IdRef(id) = operand else {
                    continue;
                };
                let numbers = self.points_to.get(id).cloned().unwrap_or_default();
                if numbers.is_empty() {
                    continue;
                }
                let access = access(instruction.class.opcode, at, self.is_image(*id));
                for number in numbers {
                    self.bindings.get_mut(&number).unwrap().access |= access;
                }
            }
        }
        self.bindings
    }
}

fn id(instruction: &Instruction, at: usize) -> Word {
    instruction.operands[at].id_ref_any().unwrap_or_default()
}

/// What an instruction does with memory that its operand at a place points to.
fn access(operation: Op, at: usize, is_image: bool) -> Access {
    match (operation, at) {
        (
            Op::AccessChain
            | Op::InBoundsAccessChain
            | Op::CopyObject
            | Op::Image
            | Op::FunctionCall
            | Op::ArrayLength
            | Op::ImageQuerySize
            | Op::ImageQuerySizeLod,
            _,
        ) => Access::empty(),
        (Op::Load, _) if is_image => Access::empty(),
        (
            Op::Load | Op::AtomicLoad | Op::ImageFetch | Op::ImageRead | Op::ImageSampleExplicitLod,
            0,
        ) => Access::READ,
        (Op::Store | Op::AtomicStore | Op::ImageWrite, 0) => Access::WRITE,
        (Op::AtomicIAdd | Op::AtomicOr | Op::AtomicUMax | Op::AtomicExchange, 0) => Access::all(),
        other => panic!("{other:?} is new to this test: say what it does"),
    }
}

/// What a module binds.
fn compiled(file: &str) -> Bindings {
    let module: &Module = MODULES
        .iter()
        .find(|module| module.file == file)
        .unwrap_or_else(|| panic!("{file} is no module"));
    let loaded = dr::load_bytes(module.spirv()).expect(module.file);
    Walk::new(&loaded).accesses()
}

/// What the table says of a module: the rows of all kernels that it is compiled for. Its instructions
/// don't tell these apart, so rows may differ in one use only.
fn declared(file: &str) -> Bindings {
    let mut bindings = Bindings::new();
    let kernels = KERNELS
        .iter()
        .filter(|kernel| kernel.modules.contains(&file));
    let rows: Vec<_> = kernels.map(|kernel| kernel.bindings).collect();
    let most = rows.iter().map(|row| row.len()).max().unwrap_or_default();
    assert!(
        rows.iter().all(|row| row.len() + 1 >= most),
        "{file}: {rows:?}"
    );
    for binding in rows.into_iter().flatten() {
        let is_image = binding.resource.is_image();
        let bound = bindings.entry(binding.number).or_insert(Bound {
            is_image,
            access: Access::empty(),
        });
        assert_eq!(bound.is_image, is_image, "{file}, {}", binding.number);
        bound.access |= binding.access;
    }
    bindings
}

fn kernels_access_what_the_table_says() {
    let files: BTreeSet<_> = KERNELS.iter().flat_map(|kernel| kernel.modules).collect();
    let mut wrong = Vec::new();
    for file in &files {
        let [found, declared] = [compiled(file), declared(file)];
        if found != declared {
            wrong.push(format!(
                "{file}\n found    {found:?}\n expected {declared:?}"
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    // Those measure a device, or show what a frame has made.
    let apart = ["rates/", "present/"];
    for module in MODULES {
        let is_apart = apart.iter().any(|folder| module.file.starts_with(folder));
        let binds = !compiled(module.file).is_empty();
        assert!(
            is_apart || !binds || files.contains(&module.file),
            "{} binds memory and is in no row",
            module.file
        );
    }
}

fn kernels_of_a_row_run_in_one_pipeline_stage() {
    for kernel in KERNELS {
        let stage = kernel.pipeline_stage();
        let alone = |module| KernelSpec {
            modules: std::slice::from_ref(module),
            ..*kernel
        };
        let mut modules = kernel.modules.iter();
        assert!(modules.all(|module| alone(module).pipeline_stage() == stage));
    }
}

tests! {
    kernels_access_what_the_table_says,
    kernels_of_a_row_run_in_one_pipeline_stage,
}
