/* GNU byteswap.h: byte order reversal. */
#ifndef _BYTESWAP_H
#define _BYTESWAP_H

#include <stdint.h>

#define bswap_16(value) __crs_swap_16(value)
#define bswap_32(value) __crs_swap_32(value)
#define bswap_64(value) __crs_swap_64(value)

uint16_t __crs_swap_16(uint16_t value);
uint32_t __crs_swap_32(uint32_t value);
uint64_t __crs_swap_64(uint64_t value);

#endif
