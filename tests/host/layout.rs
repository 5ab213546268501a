//! Reflects the compiled shaders: their structs match `layout`, and their sizes stay within what
//! every device offers.

use effigy_core::layout::{self, Control, FrameBlock, LayerLayout};
use effigy_render::vulkan::shaders::{MODULES, Module};
use effigy_train::gpu::ViewBlock;
use rspirv::{
    dr::{self, Operand},
    spirv::{Decoration, ExecutionMode, Op, StorageClass, Word},
};
use std::{
    collections::{BTreeSet, HashMap},
    mem::offset_of,
};

/// A module and its types.
struct Reflection {
    module: dr::Module,
    types: HashMap<Word, dr::Instruction>,
}

impl Reflection {
    fn new(module: &Module) -> Self {
        let module = dr::load_bytes(module.spirv())
            .unwrap_or_else(|error| panic!("{}: {error}", module.file));
        let types = module
            .types_global_values
            .iter()
            .filter_map(|i| Some((i.result_id?, i.clone())))
            .collect();
        Self { module, types }
    }

    fn decoration(&self, id: Word, decoration: Decoration) -> Option<u32> {
        self.module
            .annotations
            .iter()
            .find_map(|i| match i.operands.as_slice() {
                [
                    Operand::IdRef(target),
                    Operand::Decoration(kind),
                    Operand::LiteralBit32(value),
                ] if *target == id && *kind == decoration => Some(*value),
                _ => None,
            })
    }

    fn member_offsets(&self, id: Word) -> Vec<usize> {
        let mut offsets: Vec<(u32, usize)> = self
            .module
            .annotations
            .iter()
            .filter_map(|i| match i.operands.as_slice() {
                [
                    Operand::IdRef(target),
                    Operand::LiteralBit32(member),
                    Operand::Decoration(Decoration::Offset),
                    Operand::LiteralBit32(offset),
                ] if *target == id => Some((*member, *offset as usize)),
                _ => None,
            })
            .collect();
        offsets.sort_unstable();
        offsets.into_iter().map(|(_, offset)| offset).collect()
    }

    fn operand(&self, id: Word, at: usize) -> Word {
        match self.types[&id].operands[at] {
            Operand::IdRef(id) => id,
            Operand::LiteralBit32(value) => value,
            ref other => panic!("unexpected operand {other:?}"),
        }
    }

    /// Variables of a storage class as (variable, type pointed to).
    fn variables(&self, class: StorageClass) -> Vec<(Word, Word)> {
        let variables = self.module.types_global_values.iter().filter(|i| {
            i.class.opcode == Op::Variable && i.operands[0] == Operand::StorageClass(class)
        });
        variables
            .filter_map(|i| Some((i.result_id?, self.operand(i.result_type?, 1))))
            .collect()
    }

    /// Storage buffers that it binds: blocks that see the same one in other ways count once.
    fn storage_bindings(&self) -> usize {
        let bindings = self.module.annotations.iter().filter_map(|i| {
            let [
                Operand::IdRef(variable),
                Operand::Decoration(Decoration::Binding),
                Operand::LiteralBit32(binding),
            ] = i.operands[..]
            else {
                return None;
            };
            let buffers = self.module.types_global_values.iter();
            buffers
                .filter(|i| i.result_id == Some(variable))
                .any(|i| i.operands[0] == Operand::StorageClass(StorageClass::StorageBuffer))
                .then_some(binding)
        });
        bindings.collect::<BTreeSet<u32>>().len()
    }

    /// Bytes of a type of 32-bit scalars.
    fn size(&self, id: Word) -> u32 {
        match self.types[&id].class.opcode {
            Op::TypeArray => self.size(self.operand(id, 0)) * self.operand(self.operand(id, 1), 0),
            Op::TypeVector => self.size(self.operand(id, 0)) * self.operand(id, 1),
            Op::TypeInt | Op::TypeFloat => self.operand(id, 0) / 8,
            other => panic!("no shared variable should be of {other:?}"),
        }
    }
}

fn each(check: impl Fn(&str, &Reflection)) {
    for module in MODULES {
        check(module.file, &Reflection::new(module));
    }
}

fn the_frame_block_is_the_same_on_both_sides() {
    let expected = [
        offset_of!(FrameBlock, focal),
        offset_of!(FrameBlock, center),
        offset_of!(FrameBlock, derivative_min),
        offset_of!(FrameBlock, derivative_max),
        offset_of!(FrameBlock, size),
        offset_of!(FrameBlock, guard),
        offset_of!(FrameBlock, near),
        offset_of!(FrameBlock, key_far),
        offset_of!(FrameBlock, key_scale),
        offset_of!(FrameBlock, key_max),
        offset_of!(FrameBlock, fixed_scale),
        offset_of!(FrameBlock, position_min),
        offset_of!(FrameBlock, position_step),
        offset_of!(FrameBlock, clip),
        offset_of!(FrameBlock, gaussians),
        offset_of!(FrameBlock, nodes),
        offset_of!(FrameBlock, parts),
        offset_of!(FrameBlock, head_parts),
        offset_of!(FrameBlock, basis_quads),
        offset_of!(FrameBlock, feature_quads),
        offset_of!(FrameBlock, node_feature),
        offset_of!(FrameBlock, node_start),
        offset_of!(FrameBlock, rotation_start),
        offset_of!(FrameBlock, scale_start),
        offset_of!(FrameBlock, color_start),
        offset_of!(FrameBlock, slope),
        offset_of!(FrameBlock, layers),
        offset_of!(FrameBlock, network_quads),
        offset_of!(FrameBlock, key_start),
        offset_of!(FrameBlock, cutoff),
        offset_of!(FrameBlock, quad_opacity),
        offset_of!(FrameBlock, body_quads),
        offset_of!(FrameBlock, log_scale_min),
        offset_of!(FrameBlock, log_scale_step),
        offset_of!(FrameBlock, sh_color_start),
        offset_of!(FrameBlock, facing_start),
        offset_of!(FrameBlock, count_start),
        offset_of!(FrameBlock, count_tile),
        offset_of!(FrameBlock, cache_start),
        offset_of!(FrameBlock, cache_unit),
        offset_of!(FrameBlock, feature_start),
        offset_of!(FrameBlock, first_splat),
        offset_of!(FrameBlock, tile_side),
        offset_of!(FrameBlock, detail_level),
        offset_of!(FrameBlock, drawn),
        offset_of!(FrameBlock, covariance_scale),
        offset_of!(FrameBlock, bin_side),
        offset_of!(FrameBlock, low_pass),
        offset_of!(FrameBlock, compensation),
        offset_of!(FrameBlock, area_reach),
        offset_of!(FrameBlock, area),
        offset_of!(FrameBlock, cache_min),
        offset_of!(FrameBlock, cache_size),
        offset_of!(FrameBlock, camera_from_cache),
        offset_of!(FrameBlock, idle_parts),
        offset_of!(FrameBlock, culled_parts),
        offset_of!(FrameBlock, layer),
        offset_of!(FrameBlock, input),
        offset_of!(FrameBlock, joint),
    ];
    let layer = [
        offset_of!(LayerLayout, input_quads),
        offset_of!(LayerLayout, output_count),
        offset_of!(LayerLayout, weight),
        offset_of!(LayerLayout, bias),
    ];
    let members = expected
        .iter()
        .position(|&at| at == offset_of!(FrameBlock, layer))
        .unwrap();
    let seen = std::cell::Cell::new(0);
    each(|name, reflection| {
        for (variable, block) in reflection.variables(StorageClass::Uniform) {
            assert_eq!(
                reflection.decoration(variable, Decoration::Binding),
                Some(0),
                "{name}: the only uniform block is the frame's"
            );
            assert_eq!(
                reflection.member_offsets(block),
                expected,
                "{name}: offsets of the frame block"
            );
            let layers = reflection.operand(block, members);
            assert_eq!(
                reflection.decoration(layers, Decoration::ArrayStride),
                Some(size_of::<LayerLayout>() as u32),
                "{name}: stride of layers"
            );
            assert_eq!(
                reflection.member_offsets(reflection.operand(layers, 0)),
                layer,
                "{name}: offsets of a layer"
            );
            seen.set(seen.get() + 1);
        }
    });
    assert_eq!(
        seen.get(),
        15,
        "mlp has two modules, sh one, project two, binning four, saturation one and raster five"
    );
}

fn the_block_of_a_trained_view_is_the_same_on_both_sides() {
    for module in effigy_train::gpu::shaders::MODULES {
        let reflection = Reflection::new(module);
        for (_, block) in reflection.variables(StorageClass::Uniform) {
            // Vectors alone, the first of them three rows.
            let members = size_of::<ViewBlock>() as u32 / 16 - 3;
            let expected: Vec<usize> = (0..=members as usize)
                .map(|member| 16 * if member == 0 { 0 } else { member + 2 })
                .collect();
            assert_eq!(
                reflection.member_offsets(block),
                expected,
                "{}: offsets of the view's block",
                module.file
            );
        }
    }
    let named = [
        offset_of!(ViewBlock, camera.focal),
        offset_of!(ViewBlock, losses.l1),
        offset_of!(ViewBlock, counts),
        offset_of!(ViewBlock, image.first_row),
        offset_of!(ViewBlock, networks.activations),
        offset_of!(ViewBlock, networks.layers),
        offset_of!(ViewBlock, update.main_correction),
    ];
    assert_eq!(named, [48, 128, 160, 208, 304, 320, 400]);
}

fn the_control_block_is_the_same_on_both_sides() {
    let expected = [
        offset_of!(Control, index_count),
        offset_of!(Control, instance_count),
        offset_of!(Control, first_index),
        offset_of!(Control, vertex_offset),
        offset_of!(Control, first_instance),
        offset_of!(Control, key_count),
        offset_of!(Control, visible_count),
        offset_of!(Control, fragments),
    ];
    let found = std::cell::Cell::new(0);
    each(|name, reflection| {
        for (_, block) in reflection.variables(StorageClass::StorageBuffer) {
            let [first] = reflection.types[&block].operands.as_slice() else {
                continue;
            };
            let Operand::IdRef(member) = first else {
                continue;
            };
            if reflection.types[member].class.opcode == Op::TypeStruct {
                assert_eq!(
                    reflection.member_offsets(*member),
                    expected,
                    "{name}: offsets of the control block"
                );
                found.set(found.get() + 1);
            }
        }
    });
    assert_eq!(
        found.get(),
        17,
        "seven kernels of sort, four of binning, one of saturation and five modules of raster read \
         the control block"
    );
}

fn shaders_need_no_more_than_every_device_has() {
    each(|name, reflection| {
        let storage = reflection.storage_bindings();
        assert!(
            storage <= 4,
            "{name} binds {storage} storage buffers; 4 are guaranteed in a stage"
        );
        let shared: u32 = reflection
            .variables(StorageClass::Workgroup)
            .iter()
            .map(|(_, kind)| reflection.size(*kind))
            .sum();
        assert!(
            shared <= 16384,
            "{name} shares {shared} bytes; 16384 are guaranteed"
        );
        let size =
            reflection
                .module
                .execution_modes
                .iter()
                .find_map(|i| match i.operands.as_slice() {
                    [
                        _,
                        Operand::ExecutionMode(ExecutionMode::LocalSize),
                        Operand::LiteralBit32(x),
                        Operand::LiteralBit32(y),
                        Operand::LiteralBit32(z),
                    ] => Some(x * y * z),
                    _ => None,
                });
        let (folder, file) = name.split_once('/').unwrap();
        let expected = match folder {
            _ if !file.contains(".comp") => None,
            "mlp" => Some(layout::MLP_WORKGROUP),
            "sh" => Some(layout::SH_WORKGROUP),
            "project" => Some(layout::PROJECT_WORKGROUP),
            "binning" if file.starts_with("binning.") => Some(layout::BINNING_WORKGROUP),
            "binning" => Some(layout::BIN_WORKGROUP),
            "raster" if file.starts_with("shared_") => Some(layout::SHARED_WORKGROUP),
            "raster" | "saturation" => Some(layout::RASTER_WORKGROUP),
            "rates" => Some(layout::RATES_WORKGROUP),
            "sort" if file.starts_with("per_thread") => Some(layout::SORT_RUNS),
            "sort" => Some(layout::SORT_WORKGROUP),
            other => panic!("shaders/{other} is no stage"),
        };
        assert_eq!(size, expected, "{name}: invocations of a workgroup");
        // A device must be asked whether it has more: see `Probe::lacks_for`.
        assert!(
            size.is_none_or(|size| size <= 128) || file.starts_with("shared_"),
            "{name} has workgroups of {size:?}; 128 are guaranteed"
        );
        let version = reflection
            .module
            .header
            .as_ref()
            .map(|header| header.version());
        assert!(
            version.is_some_and(|version| version <= (1, 3)),
            "{name} is SPIR-V {version:?}; Vulkan 1.1 takes 1.3"
        );
    });
}

tests! {
    the_frame_block_is_the_same_on_both_sides,
    the_block_of_a_trained_view_is_the_same_on_both_sides,
    the_control_block_is_the_same_on_both_sides,
    shaders_need_no_more_than_every_device_has,
}
