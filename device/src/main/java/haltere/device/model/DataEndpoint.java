package haltere.device.model;

/**
 * Endpoint of the data of a camera, with default transfers.
 *
 * @param address of a bulk endpoint, 0x80 or more
 * @param usualTransfers default number of simultaneous transfers
 * @param usualBufferBytes default size of each
 */
record DataEndpoint(int address, int usualTransfers, int usualBufferBytes) {}
