/* Bytes in the other order (GNU byteswap.h). */
#include <byteswap.h>

uint16_t __crs_swap_16(uint16_t value)
{
    return value >> 8 | value << 8;
}

uint32_t __crs_swap_32(uint32_t value)
{
    return value >> 24 | (value >> 8 & 0xff00) | (value & 0xff00) << 8 | value << 24;
}

uint64_t __crs_swap_64(uint64_t value)
{
    return (uint64_t)__crs_swap_32(value) << 32 | __crs_swap_32(value >> 32);
}
