/* CRC-32 with a table of 256 entries (ISO 3309), over a buffer that changes. */
#include <stdint.h>
#include <stdio.h>

static uint32_t table[256];
static uint8_t buffer[65536];

static void make_table(void)
{
    uint32_t c;
    int n, k;

    for (n = 0; n < 256; n++) {
        c = n;
        for (k = 0; k < 8; k++)
            c = c & 1 ? 0xedb88320u ^ c >> 1 : c >> 1;
        table[n] = c;
    }
}

static uint32_t crc(const uint8_t *p, size_t length)
{
    uint32_t c = 0xffffffffu;

    while (length-- > 0)
        c = table[(c ^ *p++) & 0xff] ^ c >> 8;
    return c ^ 0xffffffffu;
}

int main(void)
{
    uint32_t sum = 0;
    int round, i;

    make_table();
    for (i = 0; i < (int) sizeof buffer; i++)
        buffer[i] = i * 31 + (i >> 8);
    for (round = 0; round < 250; round++) {
        sum ^= crc(buffer, sizeof buffer);
        buffer[sum & 0xffff]++;
    }
    printf("crc %08x\n", (unsigned) sum);
    return 0;
}
