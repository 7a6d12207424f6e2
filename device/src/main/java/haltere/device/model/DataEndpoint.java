package haltere.device.model;

/**
 * Endpoint of the data of a camera, with default transfers.
 *
 * @param address of a bulk endpoint, 0x80 or more
 * @param defaultTransfers default number of simultaneous transfers
 * @param defaultBufferBytes default size of each
 */
record DataEndpoint(int address, int defaultTransfers, int defaultBufferBytes) {}
