/* Copies of a short variable that was never set, in registers, arrays and structs. */
struct sample { char kind; short value; };

static struct sample last;

static void keep(const short *values)
{
    last.kind = 's';
    last.value = values[1];
}

int main(void)
{
    short range, values[2];
    values[0] = 1;
    values[1] = range;
    keep(values);
    return last.value > 2; // error: uninitialised read
}
