// The line of three pixels under the window of a written one, which count 1, 2 and 1: two mirrored
// pixels stand before it, and as many as it takes behind.
uint under(uint at, uint k, uint length) {
    uint place = uint(abs(int(2u * at + k) - 2));
    return place < length ? place : 2u * length - 2u - place;
}

const float SHARES[3] = float[3](0.25, 0.5, 0.25);
