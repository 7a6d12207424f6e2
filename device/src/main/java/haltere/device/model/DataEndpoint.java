package haltere.device.model;

/**
 * Where a camera's data come from, and in what pieces if nobody says otherwise.
 *
 * @param address of a bulk endpoint, 0x80 or more
 * @param usualTransfers under way at a time
 * @param usualBufferBytes of each
 */
record DataEndpoint(int address, int usualTransfers, int usualBufferBytes) {}
