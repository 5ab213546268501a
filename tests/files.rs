//! The avatar and motion files.

mod common;

#[test]
fn test_avatars_have_their_three_nearest_nodes() {
    let avatar = common::avatar(3, common::Sizes::default());
    for gaussian in 0..avatar.gaussians.len() {
        let distance = |node: usize| avatar.node_position(node).distance(avatar.position(gaussian));
        let mut all: Vec<f64> = (0..avatar.nodes.len()).map(distance).collect();
        all.sort_by(f64::total_cmp);
        let got = avatar.gaussians.node[gaussian].map(|node| distance(node.into()));
        assert_eq!(got[..], all[..3], "Gaussian {gaussian}");
    }
}

#[test]
fn the_same_seed_makes_the_same_avatar() {
    assert_eq!(common::avatar(3, common::Sizes::default()), common::avatar(3, common::Sizes::default()));
}
