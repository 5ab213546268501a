//! Names that a pickle may refer to.

use super::node::Global;
use crate::npz::{Element, Kind};

/// What a name of a module stands for; None where it is not one of those that are built.
pub fn global(module: &str, name: &str) -> Option<Global> {
    Some(match (module, name) {
        ("numpy.core.multiarray" | "numpy._core.multiarray", "_reconstruct") => Global::Reconstruct,
        ("numpy.core.multiarray" | "numpy._core.multiarray", "scalar") => Global::Scalar,
        ("numpy.core.numeric" | "numpy._core.numeric", "_frombuffer") => Global::FromBuffer,
        ("numpy", "ndarray") => Global::NdArray,
        ("numpy", "dtype") => Global::DType,
        ("collections", "OrderedDict" | "defaultdict") => Global::Dict,
        ("builtins" | "__builtin__", "dict") => Global::Dict,
        ("builtins" | "__builtin__", "list" | "set" | "frozenset") => Global::List,
        ("builtins" | "__builtin__", "tuple") | ("torch", "Size") => Global::Tuple,
        ("builtins" | "__builtin__", "bytearray") => Global::ByteArray,
        ("_codecs", "encode") => Global::Encode,
        ("joblib.numpy_pickle", "NumpyArrayWrapper") => Global::Wrapper,
        ("torch._utils", "_rebuild_tensor_v2" | "_rebuild_tensor") => Global::Tensor,
        ("torch._utils", "_rebuild_parameter") => Global::Parameter,
        ("torch.storage", "_load_from_bytes") => Global::Load,
        ("torch._utils", "_rebuild_meta_tensor_no_storage") => Global::Inert,
        ("torch", "float32" | "float64" | "float16" | "bfloat16") => Global::Inert,
        ("torch.nn.modules.container", "Sequential") => Global::Inert,
        ("torch.nn.modules.linear", "Linear") => Global::Inert,
        ("torch.nn.modules.activation", "ReLU") => Global::Inert,
        // The network of mmlphuman's checkpoints, without weights.
        ("scene.mlp", "MLP") => Global::Inert,
        ("torch" | "torch.storage", _) => Global::StorageType(storage(name)?),
        _ => return None,
    })
}

/// The numbers of a PyTorch storage's class.
fn storage(name: &str) -> Option<Element> {
    let (kind, size) = match name {
        "HalfStorage" => (Kind::Float, 2),
        "FloatStorage" => (Kind::Float, 4),
        "DoubleStorage" => (Kind::Float, 8),
        "BFloat16Storage" => (Kind::Brain, 2),
        "CharStorage" => (Kind::Signed, 1),
        "ShortStorage" => (Kind::Signed, 2),
        "IntStorage" => (Kind::Signed, 4),
        "LongStorage" => (Kind::Signed, 8),
        "ByteStorage" | "BoolStorage" | "UntypedStorage" => (Kind::Unsigned, 1),
        _ => return None,
    };
    Some(Element {
        kind,
        size,
        big_endian: false,
    })
}
