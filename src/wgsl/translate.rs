//! Translates SPIR-V to WGSL. The program that compiles the shaders has this file too, to see whether
//! a module can be translated.

use anyhow::Context;
use naga::{
    AddressSpace, ArraySize, Expression, Module, ScalarKind, ShaderStage, Statement, StorageAccess,
    Type, TypeInner,
    back::wgsl::{self, WriterFlags},
    front::spv,
    valid::{Capabilities, GlobalUse, ValidationFlags, Validator},
};

/// Translates a module with one entry point.
pub fn translate(spirv: &[u8]) -> anyhow::Result<String> {
    let mut module = spv::parse_u8_slice(spirv, &spv::Options::default())?;
    pass_built_ins(&mut module);
    let validate = |module: &Module| {
        let info = Validator::new(
            ValidationFlags::all(),
            Capabilities::SHADER_FLOAT16_IN_FLOAT32,
        )
        .validate(module);
        info.map_err(|error| anyhow::anyhow!(error.emit_to_string("")))
    };
    // WGSL cannot express the access qualifiers of SPIR-V: derive them from what the entry point
    // does.
    for (_, variable) in module.global_variables.iter_mut() {
        if let AddressSpace::Storage { access } = &mut variable.space {
            *access = StorageAccess::LOAD | StorageAccess::STORE;
        }
    }
    let info = validate(&module)?;
    let used = info.get_entry_point(0);
    // WGSL forbids writable storage in vertex shaders and barriers that depend on it, even where
    // nothing is written. So buffers that are only read are declared so.
    for (handle, variable) in module.global_variables.iter_mut() {
        if let AddressSpace::Storage { access } = &mut variable.space
            && !used[handle].intersects(GlobalUse::WRITE | GlobalUse::ATOMIC)
        {
            *access = StorageAccess::LOAD;
        }
    }
    let lengths = name_lengths(&mut module);
    let info = validate(&module)?;
    let text = wgsl::write_string(&module, &info, WriterFlags::empty())
        .context("naga can't write it as WGSL")?;
    let text = lengths.iter().fold(text, |text, (number, name)| {
        text.replace(&number.to_string(), name)
    });
    Ok(read_uniformly(&text))
}

/// Reads each shared variable that is one number with `workgroupUniformLoad`. WGSL takes any other
/// read of it for one that may differ between invocations, after which it allows no barrier. It is
/// a barrier as well, so all invocations must read such a variable at once; a shader that must not
/// has an array of one.
fn read_uniformly(text: &str) -> String {
    let names = text.lines().filter_map(|line| {
        let variable = line.strip_prefix("var<workgroup> ")?;
        variable.strip_suffix(": u32;")
    });
    names.fold(text.to_string(), |text, name| {
        let read = format!(" = {name};");
        text.replace(&read, &format!(" = workgroupUniformLoad((&{name}));"))
    })
}

/// Gives the arrays of storage buffers a length that is a named constant, defined when the module
/// is made (src/render/webgpu/kernel.rs). Browsers check every access against the length; without a
/// constant they divide the buffer's size to find it. Returns the placeholder of each length and
/// its name.
fn name_lengths(module: &mut Module) -> Vec<(u32, String)> {
    /// Occurs nowhere in the shaders.
    const FIRST: u32 = 40_000_000;
    let mut lengths = Vec::new();
    let Module {
        types,
        global_variables,
        ..
    } = module;
    for (_, variable) in global_variables.iter_mut() {
        let (AddressSpace::Storage { .. }, Some(binding)) = (variable.space, &variable.binding)
        else {
            continue;
        };
        let mut sized = types[variable.ty].clone();
        let TypeInner::Struct { members, span } = &mut sized.inner else {
            continue;
        };
        let Some(last) = members.last_mut() else {
            continue;
        };
        let TypeInner::Array {
            base,
            size: ArraySize::Dynamic,
            stride,
        } = types[last.ty].inner
        else {
            continue;
        };
        let Some(size) = std::num::NonZero::new(FIRST + binding.binding) else {
            continue;
        };
        let array = Type {
            name: None,
            inner: TypeInner::Array {
                base,
                size: ArraySize::Constant(size),
                stride,
            },
        };
        last.ty = types.insert(array, naga::Span::UNDEFINED);
        *span = last.offset + stride * size.get();
        variable.ty = types.insert(sized, naga::Span::UNDEFINED);
        lengths.push((size.get(), format!("LENGTH_{}_{stride}", binding.binding)));
    }
    lengths
}

/// Passes a compute shader's built-ins to its `main` as arguments of its entry point. naga reads
/// them from variables, which WGSL does not accept in the control flow around a barrier. Other
/// functions go on reading the variables.
fn pass_built_ins(module: &mut Module) {
    let Module {
        entry_points,
        functions,
        ..
    } = module;
    let [entry] = entry_points.as_mut_slice() else {
        return;
    };
    let outer = &entry.function;
    let called = outer.body.iter().find_map(|statement| match *statement {
        Statement::Call { function, .. } => Some(function),
        _ => None,
    });
    let Some(called) = called.filter(|_| entry.stage == ShaderStage::Compute) else {
        return;
    };
    let body = &functions[called];
    // The variable that each argument is stored in before the body is called.
    let stores = outer.body.iter().filter_map(|statement| match *statement {
        Statement::Store { pointer, value } => {
            match (&outer.expressions[pointer], &outer.expressions[value]) {
                (Expression::GlobalVariable(variable), Expression::FunctionArgument(argument)) => {
                    Some((*variable, *argument))
                }
                _ => None,
            }
        }
        _ => None,
    });
    let stores: Vec<_> = stores.collect();
    let mut inner = body.clone();
    inner.arguments.clone_from(&outer.arguments);
    let mut values = vec![false; inner.expressions.len()];
    for (handle, expression) in inner.expressions.iter_mut() {
        let known = |base: naga::Handle<Expression>, values: &[bool]| values[base.index()];
        values[handle.index()] = match *expression {
            Expression::GlobalVariable(variable) => {
                match stores.iter().find(|store| store.0 == variable) {
                    Some(&(_, argument)) => {
                        *expression = Expression::FunctionArgument(argument);
                        true
                    }
                    None => false,
                }
            }
            Expression::AccessIndex { base, .. } | Expression::Access { base, .. } => {
                known(base, &values)
            }
            // An argument is a value and needs no load: replaced by a cast to its own type.
            Expression::Load { pointer } if known(pointer, &values) => {
                *expression = Expression::As {
                    expr: pointer,
                    kind: ScalarKind::Uint,
                    convert: None,
                };
                false
            }
            _ => false,
        };
    }
    if functions.len() > 1 {
        let span = naga::Span::UNDEFINED;
        let mut whole = naga::Block::new();
        for (variable, argument) in stores {
            let variable = Expression::GlobalVariable(variable);
            let argument = Expression::FunctionArgument(argument);
            let store = Statement::Store {
                pointer: inner.expressions.append(variable, span),
                value: inner.expressions.append(argument, span),
            };
            whole.push(store, span);
        }
        whole.append(&mut inner.body);
        inner.body = whole;
    }
    entry.function = inner;
    naga::compact::compact(module, naga::compact::KeepUnused::No);
}
