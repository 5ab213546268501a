//! The compiled shaders, reflected: their structs against src/layout.rs, their sizes against what every device has.

use effigy::{
    layout::{self, Control, Frame, Layer},
    vulkan::shaders::{MODULES, Module},
};
use rspirv::{
    dr::{self, Operand},
    spirv::{Decoration, ExecutionMode, Op, StorageClass, Word},
};
use std::{collections::HashMap, mem::offset_of};

/// A module and its types.
struct Reflection {
    module: dr::Module,
    types: HashMap<Word, dr::Instruction>,
}

impl Reflection {
    fn new(module: &Module, half: bool) -> Self {
        let module = dr::load_bytes(module.spirv(half)).unwrap_or_else(|error| panic!("{}: {error}", module.file));
        let types = module.types_global_values.iter().filter_map(|i| Some((i.result_id?, i.clone()))).collect();
        Self { module, types }
    }

    fn decoration(&self, id: Word, decoration: Decoration) -> Option<u32> {
        self.module.annotations.iter().find_map(|i| match i.operands.as_slice() {
            [Operand::IdRef(target), Operand::Decoration(kind), Operand::LiteralBit32(value)] if *target == id && *kind == decoration => {
                Some(*value)
            }
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
        let variables = self
            .module
            .types_global_values
            .iter()
            .filter(|i| i.class.opcode == Op::Variable && i.operands[0] == Operand::StorageClass(class));
        variables.filter_map(|i| Some((i.result_id?, self.operand(i.result_type?, 1)))).collect()
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
        for half in [false, true].into_iter().filter(|half| !half || module.has_half()) {
            check(&module.compiled(half), &Reflection::new(module, half));
        }
    }
}

#[test]
fn the_frame_block_is_the_same_on_both_sides() {
    let expected = [
        offset_of!(Frame, focal),
        offset_of!(Frame, center),
        offset_of!(Frame, derivative_min),
        offset_of!(Frame, derivative_max),
        offset_of!(Frame, size),
        offset_of!(Frame, guard),
        offset_of!(Frame, near),
        offset_of!(Frame, key_far),
        offset_of!(Frame, key_scale),
        offset_of!(Frame, key_max),
        offset_of!(Frame, fixed_scale),
        offset_of!(Frame, position_min),
        offset_of!(Frame, position_step),
        offset_of!(Frame, clip),
        offset_of!(Frame, gaussians),
        offset_of!(Frame, nodes),
        offset_of!(Frame, parts),
        offset_of!(Frame, head_parts),
        offset_of!(Frame, basis_quads),
        offset_of!(Frame, feature_quads),
        offset_of!(Frame, node_feature),
        offset_of!(Frame, node_start),
        offset_of!(Frame, rotation_start),
        offset_of!(Frame, scale_start),
        offset_of!(Frame, color_start),
        offset_of!(Frame, slope),
        offset_of!(Frame, layers),
        offset_of!(Frame, network_quads),
        offset_of!(Frame, key_start),
        offset_of!(Frame, cutoff),
        offset_of!(Frame, margin),
        offset_of!(Frame, surface_start),
        offset_of!(Frame, surface_origin),
        offset_of!(Frame, surface_scale),
        offset_of!(Frame, hull_opacity),
        offset_of!(Frame, body_quads),
        offset_of!(Frame, log_scale_min),
        offset_of!(Frame, log_scale_step),
        offset_of!(Frame, lit_start),
        offset_of!(Frame, half_keys),
        offset_of!(Frame, count_start),
        offset_of!(Frame, count_tile),
        offset_of!(Frame, posed_start),
        offset_of!(Frame, posed_unit),
        offset_of!(Frame, feature_start),
        offset_of!(Frame, first),
        offset_of!(Frame, tile),
        offset_of!(Frame, level),
        offset_of!(Frame, drawn),
        offset_of!(Frame, spread),
        offset_of!(Frame, posed_min),
        offset_of!(Frame, posed_size),
        offset_of!(Frame, turn),
        offset_of!(Frame, idle),
        offset_of!(Frame, outside),
        offset_of!(Frame, layer),
        offset_of!(Frame, input),
        offset_of!(Frame, joint),
    ];
    let layer = [offset_of!(Layer, input_quads), offset_of!(Layer, output), offset_of!(Layer, weight), offset_of!(Layer, bias)];
    let members = expected.iter().position(|&at| at == offset_of!(Frame, layer)).unwrap();
    let seen = std::cell::Cell::new(0);
    each(|name, reflection| {
        for (variable, block) in reflection.variables(StorageClass::Uniform) {
            assert_eq!(reflection.decoration(variable, Decoration::Binding), Some(0), "{name}: the only uniform block is the frame's");
            assert_eq!(reflection.member_offsets(block), expected, "{name}: offsets of the frame block");
            let layers = reflection.operand(block, members);
            assert_eq!(reflection.decoration(layers, Decoration::ArrayStride), Some(size_of::<Layer>() as u32), "{name}: stride of layers");
            assert_eq!(reflection.member_offsets(reflection.operand(layers, 0)), layer, "{name}: offsets of a layer");
            seen.set(seen.get() + 1);
        }
    });
    assert_eq!(
        seen.get(),
        15,
        "features in three variants, harmonics in two, two of splats, the surface's two, bins and the raster's five read the frame block"
    );
}

#[test]
fn the_control_block_is_the_same_on_both_sides() {
    let expected = [
        offset_of!(Control, index_count),
        offset_of!(Control, instance_count),
        offset_of!(Control, first_index),
        offset_of!(Control, vertex_offset),
        offset_of!(Control, first_instance),
        offset_of!(Control, entering),
        offset_of!(Control, survivors),
        offset_of!(Control, fragments),
    ];
    let found = std::cell::Cell::new(0);
    each(|name, reflection| {
        for (_, block) in reflection.variables(StorageClass::StorageBuffer) {
            let [first] = reflection.types[&block].operands.as_slice() else { continue };
            let Operand::IdRef(member) = first else { continue };
            if reflection.types[member].class.opcode == Op::TypeStruct {
                assert_eq!(reflection.member_offsets(*member), expected, "{name}: offsets of the control block");
                found.set(found.get() + 1);
            }
        }
    });
    assert_eq!(found.get(), 13, "seven sort kernels, bins and the raster's five read the control block");
}

#[test]
fn shaders_need_no_more_than_every_device_has() {
    each(|name, reflection| {
        let storage = reflection.variables(StorageClass::StorageBuffer).len();
        assert!(storage <= 4, "{name} binds {storage} storage buffers; 4 are guaranteed in a stage");
        let shared: u32 = reflection.variables(StorageClass::Workgroup).iter().map(|(_, kind)| reflection.size(*kind)).sum();
        assert!(shared <= 16384, "{name} shares {shared} bytes; 16384 are guaranteed");
        let size = reflection.module.execution_modes.iter().find_map(|i| match i.operands.as_slice() {
            [
                _,
                Operand::ExecutionMode(ExecutionMode::LocalSize),
                Operand::LiteralBit32(x),
                Operand::LiteralBit32(y),
                Operand::LiteralBit32(z),
            ] => Some(x * y * z),
            _ => None,
        });
        let expected = match name.split('.').next() {
            Some("features" | "features_bytes") => Some(layout::FEATURES_SIZE),
            Some("harmonics") => Some(layout::HARMONICS_SIZE),
            Some("surface") if name.starts_with("surface.comp") => Some(layout::SURFACE_WIDTH * layout::SURFACE_HEIGHT),
            Some("splats" | "splats_posed") => Some(layout::SPLATS_SIZE),
            Some("bins") => Some(layout::BINS_SIZE),
            Some(name) if name.starts_with("raster_") => Some(layout::RASTER_SIZE),
            Some("sort_lanes_count" | "sort_lanes_scatter") => Some(layout::SORT_LANES),
            Some(name) if name.starts_with("sort_") => Some(layout::SORT_SIZE),
            _ => None,
        };
        assert_eq!(size, expected, "{name}: invocations of a workgroup");
        assert!(size.is_none_or(|size| size <= 128), "{name} has workgroups of {size:?}; 128 are guaranteed");
        let version = reflection.module.header.as_ref().map(|header| header.version());
        assert!(version.is_some_and(|version| version <= (1, 3)), "{name} is SPIR-V {version:?}; Vulkan 1.1 takes 1.3");
    });
}
