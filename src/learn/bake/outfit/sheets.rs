//! The sheets of the dressed body.

use crate::bake::body::BakedBody;
use crate::bake::joints::is_arm;
use crate::bake::outfit::garments::Outfit;
use crate::bake::outfit::shoe;
use crate::bake::surface::{Material, Sheet, SheetVertex};
use effigy_math::noise::smoothstep;

/// All sheets, the innermost first.
pub fn sheets(outfit: &Outfit, body: &BakedBody) -> Vec<Sheet> {
    let mut sheets = vec![Sheet::from_group(body, "body", Material::Skin)];
    for (group, material) in [
        ("helper-l-eye", Material::Eye),
        ("helper-r-eye", Material::Eye),
        ("helper-l-eyelashes-2", Material::Lash),
        ("helper-r-eyelashes-2", Material::Lash),
        ("helper-upper-teeth", Material::Teeth),
        ("helper-lower-teeth", Material::Teeth),
    ] {
        sheets.push(Sheet::from_group(body, group, material));
    }
    sheets.push(outfit.face.hair_sheet(body));
    // Shirt, trousers and belt are MakeHuman's tights, smoothed and inflated.
    let mut tights = Sheet::from_group(body, "helper-tights", Material::Shirt);
    tights.smooth(6);
    let garment = |material: Material, thickness: &dyn Fn(&SheetVertex) -> f64| {
        let mut sheet = Sheet {
            material,
            ..tights.clone()
        };
        sheet.inflate(thickness);
        sheet
    };
    sheets.push(garment(Material::Trousers, &|v| {
        // Wider below the knee.
        let knee = outfit.knee[0].y;
        let leg = smoothstep(-0.2, 1.0, outfit.lower_leg(v.position))
            * smoothstep(knee + 0.1, knee - 0.1, v.position.y);
        0.010 + 0.016 * leg
    }));
    sheets.push(garment(Material::Shirt, &|v| {
        // Looser above the belt and towards the elbow.
        let above_belt = v.position.y - outfit.belt;
        let blouse = smoothstep(0.0, 0.05, above_belt) * smoothstep(0.22, 0.06, above_belt);
        let on_arm = v
            .weights
            .iter()
            .any(|influence| is_arm(influence.joint) && influence.weight > 0.5);
        let sleeve = smoothstep(0.0, 0.6, outfit.upper_arm(v.position)) * f64::from(on_arm);
        0.010 + 0.010 * blouse + 0.007 * sleeve
    }));
    sheets.push(garment(Material::Belt, &|_| 0.0165));
    sheets.extend(shoe::sheets(body));
    sheets
}
