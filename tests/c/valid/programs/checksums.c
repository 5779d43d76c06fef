/* CRC-32, CRC-16, Adler-32, Fletcher, FNV and djb2 over the same text. */
#include <stdio.h>
#include <string.h>

static unsigned crc_table[256];

static void make_table(void)
{
    unsigned i, j, c;

    for (i = 0; i < 256; i++) {
        for (c = i, j = 0; j < 8; j++)
            c = c & 1 ? 0xEDB88320u ^ c >> 1 : c >> 1;
        crc_table[i] = c;
    }
}

static unsigned crc32(const unsigned char *p, int n)
{
    unsigned c = ~0u;

    while (n--)
        c = crc_table[(c ^ *p++) & 255] ^ c >> 8;
    return ~c;
}

static unsigned short crc16(const char *p, int n)
{
    unsigned short c = 0xFFFF;
    int i;

    while (n--) {
        c ^= (unsigned char) *p++ << 8;
        for (i = 0; i < 8; i++)
            c = c & 0x8000 ? c << 1 ^ 0x1021 : c << 1;
    }
    return c;
}

static unsigned long adler(const char *p, int n)
{
    unsigned long a = 1, b = 0;

    while (n--) {
        a = (a + (unsigned char) *p++) % 65521;
        b = (b + a) % 65521;
    }
    return b << 16 | a;
}

static unsigned long long fnv(const char *s)
{
    unsigned long long h = 14695981039346656037ull;

    while (*s)
        h = (h ^ (unsigned char) *s++) * 1099511628211ull;
    return h;
}

static unsigned djb2(const char *s)
{
    unsigned h = 5381;

    while (*s)
        h = (h << 5) + h + *s++;
    return h;
}

int main(void)
{
    const char *texts[] = { "", "a", "123456789", "The quick brown fox jumps over the lazy dog" };
    int i;

    make_table();
    for (i = 0; i < 4; i++) {
        int n = strlen(texts[i]);
        printf("%08x %04x %08lx %016llx %u\n", crc32((const unsigned char *) texts[i], n),
               crc16(texts[i], n), adler(texts[i], n), fnv(texts[i]), djb2(texts[i]));
    }
    return 0;
}
