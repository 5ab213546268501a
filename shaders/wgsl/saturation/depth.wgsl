@group(0) @binding(1) 
var global: texture_2d<f32>;
var<private> global_1: vec4<f32>;
var<private> global_2: f32 = 0f;

fn function_() {
    let _e9 = textureDimensions(global, 0i);
    let _e12 = global_1;
    let _e16 = ((vec2<i32>(_e12.xy) + vec2<i32>(1i, 1i)) / vec2<i32>(2i, 2i));
    let _e18 = max((_e16 - vec2<i32>(1i, 1i)), vec2<i32>(0i, 0i));
    let _e19 = min(_e16, (vec2<i32>(_e9) - vec2<i32>(1i, 1i)));
    let _e20 = textureLoad(global, _e18, 0i);
    let _e25 = textureLoad(global, vec2<i32>(_e19.x, _e18.y), 0i);
    let _e30 = textureLoad(global, vec2<i32>(_e18.x, _e19.y), 0i);
    let _e32 = textureLoad(global, _e19, 0i);
    global_2 = max(max(_e20.x, _e25.x), max(_e30.x, _e32.x));
    return;
}

@fragment 
fn main(@builtin(position) param: vec4<f32>) -> @builtin(frag_depth) f32 {
    global_1 = param;
    function_();
    let _e3 = global_2;
    return _e3;
}
