/* An address just below 4 GiB; a member behind it. */
struct big { char space[64]; int value; };

int main(void)
{
    struct big *b = (struct big *) -128;

    b->value = 5; // error: pointer outside memory
    return 0;
}
