/* A computed goto to what is no label's address. */
int main(int argc, char **argv)
{
    void *table[] = {&&end, 0};

    goto *table[argc]; // error: goto to no label
end:
    return 0;
}
