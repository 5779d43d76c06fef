/* Packing and unpacking user-defined packets: the least significant byte first, and negative
   numbers as sign and magnitude, as in all packets of the vendor's protocol. */
#include <crs/robot.h>

#define HEADER 4   /* two bytes of length, a serial number, a type */

static int put(unsigned char *buffer, unsigned short *index, unsigned long long value, int size)
{
    int i;

    for (i = 0; i < size; i++)
        buffer[*index + i] = value >> 8 * i;
    *index += size;
    return *index;
}

static unsigned long long take(const unsigned char *buffer, unsigned short *index, int size)
{
    unsigned long long value = 0;
    int i;

    for (i = 0; i < size; i++)
        value |= (unsigned long long)buffer[*index + i] << 8 * i;
    *index += size;
    return value;
}

static int put_signed(unsigned char *buffer, unsigned short *index, long long value, int size)
{
    unsigned long long sign = 1ULL << (8 * size - 1);

    return put(buffer, index, value < 0 ? (unsigned long long)-value | sign : value, size);
}

static long long take_signed(const unsigned char *buffer, unsigned short *index, int size)
{
    unsigned long long sign = 1ULL << (8 * size - 1), value = take(buffer, index, size);

    return value & sign ? -(long long)(value & ~sign) : (long long)value;
}

int init_receive_buffer(unsigned short *index)
{
    return *index = HEADER;
}

int init_send_buffer(unsigned short *index)
{
    return *index = HEADER;
}

int extract_receive_buffer_header(unsigned short *length, unsigned char *serial_number,
                                  unsigned char *packet_type, unsigned char *buffer)
{
    *length = buffer[0] | buffer[1] << 8;
    *serial_number = buffer[2];
    *packet_type = buffer[3];
    return *length;
}

int stuff_send_buffer_header(unsigned short index, unsigned char serial_number,
                             unsigned char packet_type, unsigned char *buffer)
{
    buffer[0] = index;
    buffer[1] = index >> 8;
    buffer[2] = serial_number;
    buffer[3] = packet_type;
    return index;
}

int stuffchar(signed char data, unsigned char *buffer, unsigned short *index)
{
    return put_signed(buffer, index, data, 1);
}

int stuff2byteint(signed short data, unsigned char *buffer, unsigned short *index)
{
    return put_signed(buffer, index, data, 2);
}

int stuff4byteint(signed long data, unsigned char *buffer, unsigned short *index)
{
    return put_signed(buffer, index, data, 4);
}

int stuffuchar(unsigned char data, unsigned char *buffer, unsigned short *index)
{
    return put(buffer, index, data, 1);
}

int stuff2byteuint(unsigned short data, unsigned char *buffer, unsigned short *index)
{
    return put(buffer, index, data, 2);
}

int stuff4byteuint(unsigned long data, unsigned char *buffer, unsigned short *index)
{
    return put(buffer, index, data, 4);
}

int stuffdouble(double data, unsigned char *buffer, unsigned short *index)
{
    union { double data; unsigned long long bits; } number = {data};

    return put(buffer, index, number.bits, 8);
}

signed char extractchar(unsigned char *buffer, unsigned short *index)
{
    return take_signed(buffer, index, 1);
}

signed short extract2byteint(unsigned char *buffer, unsigned short *index)
{
    return take_signed(buffer, index, 2);
}

signed long extract4byteint(unsigned char *buffer, unsigned short *index)
{
    return take_signed(buffer, index, 4);
}

unsigned char extractuchar(unsigned char *buffer, unsigned short *index)
{
    return take(buffer, index, 1);
}

unsigned short extract2byteuint(unsigned char *buffer, unsigned short *index)
{
    return take(buffer, index, 2);
}

unsigned long extract4byteuint(unsigned char *buffer, unsigned short *index)
{
    return take(buffer, index, 4);
}

double extractdouble(unsigned char *buffer, unsigned short *index)
{
    union { unsigned long long bits; double data; } number = {take(buffer, index, 8)};

    return number.data;
}
